// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangulates a closed loop with the least sum of triangle costs, by dynamic programming.
// Based on: Liepa, Filling Holes in Meshes, 2003, ch. 3.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace glark::surfel {

inline constexpr float infinite_cost = std::numeric_limits<float>::infinity();

// Triangulates the loop of corners 0 .. corners - 1. Each chord i, j has one triangle i, k, j between the chord and the
// loop. The cost of this triangle is chord_factor(i, j) * triangle_cost(i, k, j).
// Returns the corners of the triangles, or nothing if every triangulation has infinite cost.
template <typename ChordFactor, typename TriangleCost>
std::vector<std::array<std::size_t, 3>> fill_hole(std::size_t corners, const ChordFactor& chord_factor,
                                                  const TriangleCost& triangle_cost) {
  std::vector<float> least(corners * corners, 0);  // the cost of the polygon between chord i, j and the loop
  std::vector<std::size_t> third_corner(corners * corners, 0);  // the third corner of the triangle at the chord
  for (std::size_t span = 2; span < corners; ++span) {
    for (std::size_t i = 0; i + span < corners; ++i) {
      const std::size_t j = i + span;
      float& best = least[i * corners + j];
      best = infinite_cost;
      const float factor = chord_factor(i, j);
      for (std::size_t k = i + 1; k < j; ++k) {
        const float both_sides = least[i * corners + k] + least[k * corners + j];
        if (!(both_sides < best)) continue;
        const float cost = both_sides + factor * triangle_cost(i, k, j);
        if (!(cost < best)) continue;
        best = cost;
        third_corner[i * corners + j] = k;
      }
    }
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  if (!(least[corners - 1] < infinite_cost)) return triangles;
  std::vector<std::array<std::size_t, 2>> chords = {{0, corners - 1}};
  while (!chords.empty()) {
    const auto [i, j] = chords.back();
    chords.pop_back();
    if (j < i + 2) continue;
    const std::size_t k = third_corner[i * corners + j];
    triangles.push_back({i, k, j});
    chords.push_back({i, k});
    chords.push_back({k, j});
  }
  return triangles;
}

}  // namespace glark::surfel
