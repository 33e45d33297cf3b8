// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The non-empty cells of a level, in blocks of 4 x 4 x 4, so that neighbouring cells are found together.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "glark/clients/reconstruct/samples/cell_table.h"

namespace glark::reconstruct {

// A cell on the grid of a level. Its key interleaves the bits of x, y and z.
using CellIndex = std::array<std::int32_t, 3>;
std::uint64_t key_of(const CellIndex& cell);
CellIndex cell_of_key(std::uint64_t key);

// The cells low .. high, both included.
struct CellBox {
  CellIndex low{}, high{};
};

class CellBlocks {
 public:
  CellBlocks() = default;
  // The cells must be sorted by key. begins[i] is the first record of cell i; the last element is the end of the last
  // cell.
  CellBlocks(const std::vector<std::uint64_t>& keys, const std::vector<std::uint32_t>& begins);

  // Calls body(begin, end) for the records of the cells in the box, which lies within the root. One call may cover
  // several consecutive cells.
  template <typename Body>
  void each(const CellBox& box, const Body& body) const;

 private:
  static constexpr unsigned bits = 2;  // for each coordinate within a block
  static constexpr std::int32_t side = 1 << bits;
  static constexpr unsigned cells = 1U << (3 * bits);

  // The cells are in the order of their keys.
  struct Block {
    std::uint64_t occupied = 0;
    std::array<std::uint32_t, cells + 1> begins{};
  };

  static constexpr std::uint64_t all_where(unsigned axis, std::int32_t low, std::int32_t high) {
    std::uint64_t mask = 0;
    for (unsigned i = 0; i < cells; ++i) {
      const auto at = static_cast<std::int32_t>(((i >> axis) & 1U) | (((i >> (axis + 3)) & 1U) << 1U));
      mask |= std::uint64_t{at >= low && at <= high} << i;
    }
    return mask;
  }
  using Masks = std::array<std::array<std::array<std::uint64_t, side>, side>, 3>;  // [axis][low][high]
  static constexpr Masks all_masks() {
    Masks result{};
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (std::size_t low = 0; low < side; ++low) {
        for (std::size_t high = low; high < side; ++high)
          result[axis][low][high] = all_where(axis, static_cast<std::int32_t>(low), static_cast<std::int32_t>(high));
      }
    }
    return result;
  }
  static const Masks masks;

  static std::uint64_t part_of(const CellBox& box, unsigned axis, std::int32_t block) {
    const std::int32_t low = box.low[axis] - side * block, high = box.high[axis] - side * block;
    return masks[axis][static_cast<std::size_t>(low < 0 ? 0 : low)]
                [static_cast<std::size_t>(high < side ? high : side - 1)];
  }

  CellTable table_;
  std::vector<Block> blocks_;
};

template <typename Body>
void CellBlocks::each(const CellBox& box, const Body& body) const {
  for (std::int32_t z = box.low[2] >> bits; z <= box.high[2] >> bits; ++z) {
    for (std::int32_t y = box.low[1] >> bits; y <= box.high[1] >> bits; ++y) {
      for (std::int32_t x = box.low[0] >> bits; x <= box.high[0] >> bits; ++x) {
        const std::uint32_t number = table_.find(key_of({x, y, z}));
        if (number == CellTable::absent) continue;
        const Block& block = blocks_[number];
        const std::uint64_t wanted = part_of(box, 0, x) & part_of(box, 1, y) & part_of(box, 2, z);
        // Cells without records do not end a run of cells.
        const std::uint64_t passable = wanted | ~block.occupied;
        for (std::uint64_t rest = wanted & block.occupied; rest != 0;) {
          const auto first = static_cast<unsigned>(std::countr_zero(rest));
          const std::uint64_t barred = ~passable >> first;
          const unsigned last = barred == 0 ? cells : first + static_cast<unsigned>(std::countr_zero(barred));
          body(block.begins[first], block.begins[last]);
          rest &= last == cells ? 0 : ~std::uint64_t{0} << last;
        }
      }
    }
  }
}

}  // namespace glark::reconstruct
