// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A grid of cubes over all of space, and Morton codes of its cubes: the codes of the cubes within a larger cube of the
// octree follow one another.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace glark::stream {

// Spreads 21 bits: bit i becomes bit 3 i.
inline std::uint64_t every_third_bit(std::uint64_t x) {
  x = (x | (x << 32)) & 0x001F00000000FFFFU;
  x = (x | (x << 16)) & 0x001F0000FF0000FFU;
  x = (x | (x << 8)) & 0x100F00F00F00F00FU;
  x = (x | (x << 4)) & 0x10C30C30C30C30C3U;
  return (x | (x << 2)) & 0x1249249249249249U;
}
inline std::uint32_t gather_third_bits(std::uint64_t x) {
  x &= 0x1249249249249249U;
  x = (x | (x >> 2)) & 0x10C30C30C30C30C3U;
  x = (x | (x >> 4)) & 0x100F00F00F00F00FU;
  x = (x | (x >> 8)) & 0x001F0000FF0000FFU;
  x = (x | (x >> 16)) & 0x001F00000000FFFFU;
  return static_cast<std::uint32_t>((x | (x >> 32)) & 0x1FFFFFU);
}

struct Lattice {
  static constexpr unsigned levels = 21;  // of the octree whose finest cubes are the lattice's

  std::array<double, 3> anchor{};  // the corner of the cube in the middle of the octree
  double side = 1;                 // of a cube

  // The cube of a position. Positions beyond the octree belong to the cubes at its border.
  std::array<std::uint32_t, 3> cube(const double* position) const {
    constexpr double middle = 1U << (levels - 1), last = (1U << levels) - 1;
    std::array<std::uint32_t, 3> cube{};
    for (std::size_t k = 0; k < 3; ++k)
      cube[k] = static_cast<std::uint32_t>(std::clamp((position[k] - anchor[k]) / side + middle, 0.0, last));
    return cube;
  }
  static std::uint64_t key(const std::array<std::uint32_t, 3>& cube) {
    return every_third_bit(cube[0]) | (every_third_bit(cube[1]) << 1) | (every_third_bit(cube[2]) << 2);
  }
  // The least corner of the cube that has 2^level cubes of the lattice along an edge, and begins at this key.
  std::array<double, 3> corner(std::uint64_t key) const {
    constexpr double middle = 1U << (levels - 1);
    return {anchor[0] + side * (gather_third_bits(key) - middle),
            anchor[1] + side * (gather_third_bits(key >> 1) - middle),
            anchor[2] + side * (gather_third_bits(key >> 2) - middle)};
  }
};

}  // namespace glark::stream
