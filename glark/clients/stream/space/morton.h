// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Morton codes of cubes: the codes of the cubes within a larger cube of an octree follow one another.
#pragma once

#include <array>
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

inline std::uint64_t morton_code(const std::array<std::uint32_t, 3>& cube) {
  return every_third_bit(cube[0]) | (every_third_bit(cube[1]) << 1) | (every_third_bit(cube[2]) << 2);
}

}  // namespace glark::stream
