// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A copy of a block with one row of its neighbours.
#pragma once

#include "glark/clients/reconstruct/contour/blocks.h"

namespace glark::reconstruct {

inline constexpr std::int32_t wide = block_side + 1;  // the side of a block plus one row of a neighbour
inline constexpr std::size_t wide_cells = 9UL * 9UL * 9UL;
using WideValues = std::array<float, wide_cells>;

inline std::uint32_t in_wide(std::int32_t x, std::int32_t y, std::int32_t z) {
  return static_cast<std::uint32_t>(x + wide * (y + wide * z));
}

// Copies a block with one row of its neighbours: those after it (side 1) or those before it (side -1).
template <typename Value, typename Get>
void gather(const Blocks& blocks, std::uint32_t number, int side, Value missing, const Get& get,
            std::array<Value, wide_cells>& out) {
  const CellIndex place = blocks.places[number];
  for (int which = 0; which < 8; ++which) {
    const CellIndex apart{which & 1, (which >> 1) & 1, which >> 2};
    const std::uint32_t from =
        which == 0 ? number
                   : blocks.find({place[0] + side * apart[0], place[1] + side * apart[1], place[2] + side * apart[2]});
    // In the copy, the block starts at 1 if the neighbours lie before it, and at 0 if they lie after it.
    CellIndex low{}, high{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (apart[i] == 0) {
        low[i] = side > 0 ? 0 : 1;
        high[i] = low[i] + block_side;
      } else {
        low[i] = side > 0 ? block_side : 0;
        high[i] = low[i] + 1;
      }
    }
    for (std::int32_t z = low[2]; z < high[2]; ++z) {
      for (std::int32_t y = low[1]; y < high[1]; ++y) {
        for (std::int32_t x = low[0]; x < high[0]; ++x) {
          const auto local = [&](std::int32_t i) { return (side > 0 ? i : i + block_side - 1) % block_side; };
          out[in_wide(x, y, z)] =
              from == CellTable::absent ? missing : get(from, corner_in_block(local(x), local(y), local(z)));
        }
      }
    }
  }
}

// The values at the corners of a block's cells.
inline void values_of(const Blocks& blocks, std::uint32_t number, WideValues& values) {
  gather(
      blocks, number, 1, no_value, [&](std::uint32_t from, std::size_t i) { return blocks.values[from][i]; }, values);
}

}  // namespace glark::reconstruct
