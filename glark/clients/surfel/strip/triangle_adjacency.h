// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds the neighbours of triangles: pairs of half-edges in opposite directions.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/level/candidate.h"

namespace glark::surfel {

// Works on sets of triangles one by one, and reuses its memory.
class TriangleAdjacency {
 public:
  static constexpr std::uint32_t no_link = 0xFFFFFFFFU;
  static std::uint32_t triangle_of(std::uint32_t link) { return link >> 2; }
  static std::uint32_t side_of(std::uint32_t link) { return link & 3; }

  // Two triangles that are mirror images of each other are not neighbours.
  void build(std::span<const Triangle> triangles);

  // Returns for each side the neighbour across it and the side there, or no_link. Side i is the edge opposite to corner
  // i.
  const std::array<std::uint32_t, 3>& links(std::uint32_t triangle) const { return links_[triangle]; }

 private:
  void add_half_edge(std::span<const Triangle> triangles, std::uint32_t triangle, std::uint32_t side, int shift);

  std::vector<std::array<std::uint32_t, 3>> links_;  // the last one is a dummy
  std::vector<std::uint64_t> half_edges_;  // the two ends of each link's half-edge; no_edge if the half-edge has a pair
  std::vector<std::uint32_t> table_;       // hash table of links
};

}  // namespace glark::surfel
