// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The refined vertices that the sides of a coarse edge have along it, bit by bit.
#pragma once

#include <algorithm>
#include <map>
#include <set>

#include "tests/core/support/meshes/split_meshes.h"

namespace glark::core::test {

using Points = std::set<PositionBits>;

inline PositionBits bits_of(const Vector& position) {
  return test::bits_of(RefinedVertex{{position[0], position[1], position[2], 1}, {}, 0});
}

// Coarse edges by the positions of their ends, with the points that every side has along the edge.
inline std::map<std::pair<PositionBits, PositionBits>, std::vector<Points>> sides_of_edges(
    const SplitMesh& mesh, const std::vector<RefinedVertex>& refined) {
  std::vector<std::array<Points, 3>> sides(mesh.triangles());
  for (const RefinedVertex& vertex : refined) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (vertex.weights[(k + 2) % 3] == 0) {
        sides.at(static_cast<std::size_t>(vertex.triangle))[k].insert(test::bits_of(vertex));
      }
    }
  }
  std::map<std::pair<PositionBits, PositionBits>, std::vector<Points>> edges;
  for (std::size_t t = 0; t < mesh.triangles(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PositionBits from = bits_of(mesh.vertices[3 * t + k].position);
      const PositionBits to = bits_of(mesh.vertices[3 * t + (k + 1) % 3].position);
      edges[std::minmax(from, to)].push_back(sides[t][k]);
    }
  }
  return edges;
}

// Counts the edges whose sides do not all have the same points.
inline int parted_edges(const SplitMesh& mesh, const std::vector<RefinedVertex>& refined) {
  int parted = 0;
  for (const auto& [ends, sides] : sides_of_edges(mesh, refined)) {
    EXPECT_GE(sides[0].size(), ends.first == ends.second ? 1U : 2U);
    const bool together =
        std::all_of(sides.begin(), sides.end(), [&sides = sides](const Points& side) { return side == sides[0]; });
    parted += together ? 0 : 1;
  }
  return parted;
}

}  // namespace glark::core::test
