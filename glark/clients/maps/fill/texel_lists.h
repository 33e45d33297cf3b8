// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The texels of a raster that have no sample, sorted by how they are filled.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::maps {

enum class TexelState : std::uint8_t { known, unknown, outside };

// The states of a raster's texels, within a frame of texels outside.
struct StateMap {
  unsigned width = 0, height = 0;  // of the raster
  std::vector<TexelState> states;  // [(width + 2) * (height + 2)]

  std::size_t stride() const { return std::size_t{width} + 2; }
  std::size_t at(unsigned x, unsigned y) const { return (std::size_t{y} + 1) * stride() + x + 1; }
};

// A cell of a coarse level has four children: texels, or cells of the finer level. Child 4 * cell + quadrant, where the
// quadrant is 0 to 3: left lower, right lower, left upper, right upper. Lower means the row before.
constexpr std::uint32_t quadrant_of(unsigned x, unsigned y) { return x % 2 + 2 * (y % 2); }

// A texel that is filled. `child` says which child it is of the first coarse level.
struct ListedTexel {
  std::uint32_t index, child;
};

// A texel on the border of the raster. `has_neighbour` is for left, right, lower and upper.
struct BorderTexel {
  std::uint32_t index, child;
  std::array<bool, 4> has_neighbour;
};

struct TexelLists {
  StateMap map;
  std::size_t known = 0;
  std::vector<std::uint32_t> single;  // inside the raster, all neighbours have samples
  std::vector<ListedTexel> inner;     // inside the raster; a row's even texels before the odd ones of the row before
  std::vector<BorderTexel> border;    // on the border of the raster
  std::vector<std::uint32_t> row;     // scratch memory
  std::vector<ListedTexel> odd;       // scratch memory

  // Sorts the texels. Single texels are outside in the map, because no other texel depends on them. Cells are numbered
  // by their positions, row by row.
  void build(unsigned width, unsigned height, std::span<const float> weights);
};

}  // namespace glark::maps
