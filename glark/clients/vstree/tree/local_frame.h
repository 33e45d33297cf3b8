// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The frame of a transition node within the unit cube, and the grid of its quadtree.
#pragma once

#include <glark/vstree.h>

#include <span>

#include "glark/clients/common/points/moments.h"

namespace glark::vstree {

using namespace common;  // Float4, records and workers

inline constexpr unsigned quadtree_levels = 16;

struct LocalFrame {
  Float4 origin{};
  Float4 columns[3];  // column i: the i-th coordinates of u, v and the normal
  float low[2] = {};  // the bounding rectangle
  float size[2] = {};
  float scale[2] = {};  // the scale to the quadtree's last level; 0 for a rectangle without extent

  Float4 turn(Float4 direction) const {
    return splat<0>(direction) * columns[0] + splat<1>(direction) * columns[1] + splat<2>(direction) * columns[2];
  }
  Float4 inside(Float4 point) const { return turn(point - origin); }

  // Returns the cell of a position inside the frame, on the last level, clamped to the rectangle.
  std::array<std::uint32_t, 2> cell(Float4 position) const {
    constexpr float end = (1U << quadtree_levels) - 1;
    constexpr Float4 last{end, end, 0, 0};
    const Float4 scaled = (position - Float4{low[0], low[1], 0, 0}) * Float4{scale[0], scale[1], 0, 0};
    const Int4 cell = __builtin_convertvector(least(greatest(scaled, Float4{}), last), Int4);
    return {static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1])};
  }

  // Makes the rectangle the bounding rectangle of the records.
  void fit(std::span<const Record> records);
  Frame in_space(const Cube& cube, std::uint32_t node) const;
};

LocalFrame frame_of(std::span<const Record> records, const Moments& moments);

}  // namespace glark::vstree
