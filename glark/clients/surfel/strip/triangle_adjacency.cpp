// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/triangle_adjacency.h"

#include <algorithm>
#include <cstddef>

namespace glark::surfel {
namespace {

constexpr std::uint64_t no_edge = ~std::uint64_t{0};

constexpr std::uint64_t half_edge(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

}  // namespace

// Searches for the opposite half-edge and links the two. A branch on whether it exists would be mispredicted. Instead,
// links to a dummy triangle replace missing half-edges.
inline void TriangleAdjacency::add_half_edge(std::span<const Triangle> triangles, std::uint32_t t, std::uint32_t side,
                                             int shift) {
  const auto count = static_cast<std::uint32_t>(triangles.size());
  const std::uint32_t dummy = count << 2;
  const std::size_t mask = table_.size() - 1;
  const std::uint32_t tip = triangles[t][side];
  const std::uint32_t from = triangles[t][side == 2 ? 0 : side + 1], to = triangles[t][side == 0 ? 2 : side - 1];
  const std::uint64_t opposite = half_edge(to, from);
  half_edges_[dummy] = opposite;  // ends the search
  std::size_t at = half_edge(std::min(from, to), std::max(from, to)) * 0x9E3779B97F4A7C15U >> shift;
  std::uint32_t other = table_[at];
  while (half_edges_[other] != opposite ||
         (triangles[std::min(triangle_of(other), count - 1)][side_of(other)] == tip && other != dummy)) {
    at = (at + 1) & mask;
    other = table_[at];
  }
  const std::uint32_t is_first = other == dummy ? 1 : 0;  // 1: this is the first half-edge of a pair
  const std::uint32_t link = t << 2 | side;
  table_[at] = link;
  half_edges_[link] = half_edge(from, to) | (std::uint64_t{is_first} - 1);
  half_edges_[other] = no_edge;
  links_[t][side] = other | (0 - is_first);
  links_[triangle_of(other)][side_of(other)] = link;
}

void TriangleAdjacency::build(std::span<const Triangle> triangles) {
  const auto count = static_cast<std::uint32_t>(triangles.size());
  const std::uint32_t dummy = count << 2;
  links_.resize(count + 1);
  half_edges_.resize(dummy + 1);
  int bits = 6;
  while (std::size_t{1} << bits < 8 * triangles.size()) ++bits;
  table_.assign(std::size_t{1} << bits, dummy);
  for (std::uint32_t t = 0; t < count; ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) add_half_edge(triangles, t, side, 64 - bits);
  }
}

}  // namespace glark::surfel
