// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Records sorted into the cells of a regular grid of 2^levels cells a side, and the cells of all coarser levels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/common/points/moments.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

// Of bits up to 10: bit i goes to 3 i, or to 2 i.
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

// The key of a cube on the level above the last one by `shift`.
inline std::uint32_t cube_key(const std::array<std::uint32_t, 3>& cell, unsigned shift) {
  return every_third_bit(cell[0] >> shift) | (every_third_bit(cell[1] >> shift) << 1) |
         (every_third_bit(cell[2] >> shift) << 2);
}

// One that has samples.
struct Cell {
  std::uint32_t key = 0;          // on its level
  std::uint32_t begin = 0;        // of its records
  std::uint32_t first_child = 0;  // on the next finer level, where its children are neighbours
};

struct Cells {
  // [levels + 1], the coarsest first, each sorted by key, with one more cell at the end that has only `begin` and `first_child`.
  std::vector<std::vector<Cell>> levels;
  std::vector<std::vector<Moments>> moments;  // of the cells of each level, or empty: not asked for

  const Moments* moments_of(std::size_t level, std::size_t cell) const {
    return moments.empty() ? nullptr : &moments[level][cell];
  }
};

// `begins` as from sort_by_key(), for records that are sorted; key_bits: 3 for cubes, 2 for rectangles.
Cells cells_of(std::span<const std::uint32_t> begins, unsigned levels, unsigned key_bits);
void add_moments(Cells& cells, std::span<const Record> sorted, const Workers& workers);

}  // namespace glark::vstree
