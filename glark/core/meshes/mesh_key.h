// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What identifies a mesh: the source of its positions. Neither the program nor the range of a draw is part of the key:
// a depth pre-pass may draw a mesh in one piece that is drawn by materials later.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "glark/core/state/arrays/vertex_arrays.h"

namespace glark::core {

struct MeshKey {
  std::array<std::uint64_t, 3> words{};
  bool operator==(const MeshKey&) const = default;
};

// Vertices of glBegin and everything else that has no source: one group in each context.
inline constexpr MeshKey loose_mesh{};

// Positions in a buffer or in client memory. Offsets in one buffer that differ by whole vertices give the same key. A
// buffer that was deleted and made again with the same name has a new generation.
constexpr MeshKey mesh_of(const AttributeSource& source, GLsizei packed) {
  const auto stride = static_cast<std::uint64_t>(source.stride != 0 ? source.stride : packed);
  const auto first = static_cast<std::uint64_t>(source.offset) + source.relative_offset;
  const bool modulo = source.buffer != 0 && stride != 0;
  return {{source.buffer | (stride << 32U), source.buffer != 0 ? source.generation + 1 : 0,
           modulo ? first % stride : first}};
}

// A draw of a display list. `identity`: ListSegment::identity.
constexpr MeshKey mesh_of_list(std::uint64_t identity) { return {{~std::uint64_t{0}, identity, 0}}; }

// The source of a mesh. Buffers keep their name for as long as their mesh lives; the address of client memory and a
// display list may be new in every frame.
enum class MeshSource { client, list, buffer };
constexpr MeshSource source_of(const MeshKey& key) {
  constexpr std::uint64_t name_bits = 0xffffffffU;
  return key.words[0] == ~std::uint64_t{0} ? MeshSource::list
         : (key.words[0] & name_bits) == 0 ? MeshSource::client
                                           : MeshSource::buffer;
}

struct MeshKeyHash {
  std::size_t operator()(const MeshKey& key) const {
    std::uint64_t hash = 0x9e3779b97f4a7c15U;
    for (const std::uint64_t word : key.words) {
      hash = (hash ^ word) * 0xff51afd7ed558ccdU;
      hash ^= hash >> 32U;
    }
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace glark::core
