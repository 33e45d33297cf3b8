// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A grid of cubes over all of space.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "glark/clients/stream/space/morton.h"

namespace glark::stream {

struct Lattice {
  static constexpr unsigned levels = 21;  // of the octree whose finest cubes are the lattice's

  std::array<double, 3> anchor{};  // the corner of the cube in the middle of the octree
  double side = 1;                 // of a cube
  double cubes_a_unit = 1;         // 1 / side

  // The cube of a position. Positions beyond the octree belong to the cubes at its border.
  std::array<std::uint32_t, 3> cube(const double* position) const {
    constexpr double middle = 1U << (levels - 1), last = (1U << levels) - 1;
    std::array<std::uint32_t, 3> cube{};
    for (std::size_t k = 0; k < 3; ++k)
      cube[k] = static_cast<std::uint32_t>(std::clamp((position[k] - anchor[k]) * cubes_a_unit + middle, 0.0, last));
    return cube;
  }
  static std::uint64_t key(const std::array<std::uint32_t, 3>& cube) { return morton_code(cube); }
  // The least corner of the cube that has 2^level cubes of the lattice along an edge, and begins at this key.
  std::array<double, 3> corner(std::uint64_t key) const {
    constexpr double middle = 1U << (levels - 1);
    return {anchor[0] + side * (gather_third_bits(key) - middle),
            anchor[1] + side * (gather_third_bits(key >> 1) - middle),
            anchor[2] + side * (gather_third_bits(key >> 2) - middle)};
  }
};

}  // namespace glark::stream
