// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/keep/client_arrays.h"

// Without a library that programs would have to load.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <limits>
#include <type_traits>

namespace glark::core {
namespace {

std::size_t bytes_of_index(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : type == GL_UNSIGNED_INT ? 4 : 0;
}

template <typename Index>
VertexRange range_of(std::span<const std::byte> indices) {
  const auto* at = reinterpret_cast<const Index*>(indices.data());
  Index least = std::numeric_limits<Index>::max();
  Index greatest = 0;
  for (const Index* end = at + indices.size() / sizeof(Index); at != end; ++at) {
    least = std::min(least, *at);
    greatest = std::max(greatest, *at);
  }
  return {static_cast<std::int64_t>(least), static_cast<std::int64_t>(greatest) - static_cast<std::int64_t>(least) + 1};
}

GLint components(int slot, const AttributeSource& source) {
  return slot == normal_slot             ? 3  // GL gives no size for these two
         : slot == fog_coordinate_slot   ? 1
         : source.size == GLint{GL_BGRA} ? 4
                                         : source.size;
}

}  // namespace

ContentHash hash_of(std::span<const std::byte> content) {
  const XXH128_hash_t hash = XXH3_128bits(content.data(), content.size());
  return {hash.low64, hash.high64};
}

std::span<const std::byte> client_indices(const ArrayDraw& draw) {
  const std::size_t bytes = bytes_of_index(draw.index_type);
  const bool aligned = bytes > 0 && reinterpret_cast<std::uintptr_t>(draw.indices) % bytes == 0;
  if (draw.indices == nullptr || !aligned || draw.count <= 0) {
    return {};
  }
  return {static_cast<const std::byte*>(draw.indices), bytes * static_cast<std::size_t>(draw.count)};
}

std::optional<VertexRange> vertices_read(const ArrayDraw& draw, std::span<const std::byte> indices) {
  if (draw.index_type == 0) {
    return draw.count > 0 ? std::optional(VertexRange{draw.first, draw.count}) : std::nullopt;
  }
  constexpr std::int64_t most_unread = 4;
  if (indices.empty()) {
    return std::nullopt;
  }
  VertexRange range = draw.index_type == GL_UNSIGNED_BYTE    ? range_of<std::uint8_t>(indices)
                      : draw.index_type == GL_UNSIGNED_SHORT ? range_of<std::uint16_t>(indices)
                                                             : range_of<std::uint32_t>(indices);
  range.first += draw.base_vertex;
  return range.first >= 0 && range.count <= most_unread * draw.count ? std::optional(range) : std::nullopt;
}

std::span<const std::byte> bytes_read(int slot, const AttributeSource& source, const VertexRange& range) {
  constexpr std::int64_t least_address = 65536;  // below, Linux maps nothing
  // In a program of 32 bits, half of all addresses are negative as a GLintptr.
  const auto address = static_cast<std::int64_t>(static_cast<std::make_unsigned_t<GLintptr>>(source.offset));
  const std::int64_t element = packed_stride(components(slot, source), source.type);
  const std::int64_t stride = source.stride != 0 ? source.stride : element;
  if (address < least_address || element <= 0 || source.divisor != 0) {
    return {};
  }
  const std::int64_t first = address + source.relative_offset + stride * range.first;
  const std::int64_t bytes = stride * (range.count - 1) + element;
  return {reinterpret_cast<const std::byte*>(static_cast<std::uintptr_t>(first)), static_cast<std::size_t>(bytes)};
}

}  // namespace glark::core
