// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vertex arrays in client memory. The application may write them unseen, so a draw is known by a hash of the bytes that
// it reads. The address does not matter: programs allocate their arrays again in every frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "glark/core/capture/draw_call.h"
#include "glark/core/state/arrays/vertex_arrays.h"

namespace glark::core {

// 128 bits: draws with equal hashes are taken for equal.
struct ContentHash {
  std::uint64_t low = 0;
  std::uint64_t high = 0;
  bool operator==(const ContentHash&) const = default;
};
ContentHash hash_of(std::span<const std::byte> content);

// The vertices that a draw reads, and perhaps others between them.
struct VertexRange {
  std::int64_t first = 0;
  std::int64_t count = 0;
};

// The indices of a draw in client memory; empty if there are none. The application owns them.
std::span<const std::byte> client_indices(const ArrayDraw& draw);
// The vertices of a draw without indices, or with `indices`. Empty: nothing is read, or the indices lie so far apart that
// most vertices between them are not read.
std::optional<VertexRange> vertices_read(const ArrayDraw& draw, std::span<const std::byte> indices);
// The bytes of an array in client memory that hold these vertices. Empty: the format or the address is not known, or each
// instance has its own value.
std::span<const std::byte> bytes_read(int slot, const AttributeSource& source, const VertexRange& range);

}  // namespace glark::core
