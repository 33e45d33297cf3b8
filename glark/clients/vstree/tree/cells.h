// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The cells of a regular grid, into which records are sorted, and the cells of all coarser levels. The grid has
// 2^levels cells along each axis.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/points/moments.h"
#include "glark/clients/common/workers.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// Spreads up to 10 bits. Bit i becomes bit 3 i, or bit 2 i.
inline std::uint32_t every_third_bit(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FFU;
  x = (x | (x << 8)) & 0x0300F00FU;
  x = (x | (x << 4)) & 0x030C30C3U;
  return (x | (x << 2)) & 0x09249249U;
}
inline std::uint32_t every_second_bit(std::uint32_t x) {
  x = (x | (x << 8)) & 0x00FF00FFU;
  x = (x | (x << 4)) & 0x0F0F0F0FU;
  x = (x | (x << 2)) & 0x33333333U;
  return (x | (x << 1)) & 0x55555555U;
}

// The key of a cube, `shift` levels above the last one.
inline std::uint32_t cube_key(const std::array<std::uint32_t, 3>& cell, unsigned shift) {
  return every_third_bit(cell[0] >> shift) | (every_third_bit(cell[1] >> shift) << 1) |
         (every_third_bit(cell[2] >> shift) << 2);
}

// A cell that has samples.
struct Cell {
  std::uint32_t key = 0;          // the key on the cell's level
  std::uint32_t begin = 0;        // its first record
  std::uint32_t first_child = 0;  // an index on the next finer level, where the children follow one another
};

struct Cells {
  // [levels + 1], the coarsest first. The cells of a level are sorted by key. A last element ends the level; it has
  // only `begin` and `first_child`.
  std::vector<std::vector<Cell>> levels;
  std::vector<std::vector<Moments>> moments;  // for the cells of each level; empty unless add_moments() was called

  const Moments* moments_of(std::size_t level, std::size_t cell) const {
    return moments.empty() ? nullptr : &moments[level][cell];
  }
};

// begins: the result of sort_by_key(). key_bits: 3 for cubes, 2 for rectangles.
Cells cells_of(std::span<const std::uint32_t> begins, unsigned levels, unsigned key_bits);
void add_moments(Cells& cells, std::span<const Record> sorted, const Workers& workers);

}  // namespace glark::vstree
