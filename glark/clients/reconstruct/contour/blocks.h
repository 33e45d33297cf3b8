// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The implicit function at the corners of the cells near the transition layer, in blocks of corners.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "glark/clients/reconstruct/contour/transition_layer.h"

namespace glark::reconstruct {

inline constexpr std::int32_t block_side = 8;  // in corners
inline constexpr std::size_t block_corners = 512;

inline std::uint32_t corner_in_block(std::int32_t x, std::int32_t y, std::int32_t z) {
  return static_cast<std::uint32_t>(x + block_side * (y + block_side * z));
}

// Signed distances in cells of the grid: negative inside, no_value where no plane reaches.
inline constexpr float no_value = std::numeric_limits<float>::max();
using BlockValues = std::array<float, block_corners>;

struct Blocks {
  CellTable table;
  std::vector<CellIndex> places;  // in units of blocks
  std::vector<BlockValues> values;
  std::vector<std::uint32_t> begins;  // [blocks + 1]
  std::vector<std::uint32_t> planes;  // the planes that reach block i are at begins[i] .. begins[i + 1]

  std::span<const std::uint32_t> planes_of(std::uint32_t block) const {
    return {planes.data() + begins[block], begins[block + 1] - begins[block]};
  }
  std::uint32_t find(const CellIndex& place) const {
    for (const std::int32_t i : place) {
      if (i < 0) return CellTable::absent;
    }
    return table.find(key_of(place));
  }
};

// The greatest height above or below a plane at which the plane counts, in cells.
inline float band_of(float radius) { return std::max(2.5F, 0.8F * radius); }

// Hermite's kernel. t is the squared distance, relative to the radius.
inline Float4 hermite(Float4 t) {
  const Float4 root{std::sqrt(t[0]), std::sqrt(t[1]), std::sqrt(t[2]), std::sqrt(t[3])};
  return 1 + t * (2 * root - 3);
}

// Evaluates the partition of unity of the planes near each corner. A plane must face the same way as the nearest one.
// So the two sides of a thin sheet do not mix.
Blocks evaluate(const TransitionLayer& layer, unsigned level, const Workers& workers);

}  // namespace glark::reconstruct
