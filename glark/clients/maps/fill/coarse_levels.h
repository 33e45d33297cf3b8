// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The coarse levels of the multigrid solver: cells of 2 x 2 texels, of 4 x 4 texels, and so on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/clients/maps/fill/texel_blocks.h"
#include "glark/clients/maps/fill/texel_lists.h"

namespace glark::maps {

// The equation of a cell: (known + sum of weights) * value - sum of weights * neighbours' values = right side.
// A weight is the number of pairs of texels, divided by a distance in texels.
struct Cell {
  std::array<float, 4> weights;             // of the left, right, lower and upper neighbour
  std::array<std::uint32_t, 4> neighbours;  // the cell itself where the weight is 0
  float known;                              // the weight of the samples
  float count;                              // its texels without a sample
  float known_scale;                        // 1 / the distance of the samples
  float inverse;                            // 1 / (known + sum of weights)
  std::uint32_t child;                      // of the next coarser level
  std::uint32_t position;                   // row by row
};

// A level has cells only where it covers texels without samples.
struct Level {
  unsigned width = 0, height = 0;
  std::vector<std::uint32_t> numbers;  // [width * height]: the index of the cell at a position, or no_cell
  std::vector<Cell> cells;             // those whose column + row is even are first
  std::vector<Float4> right_sides;     // [cells * blocks]
  std::vector<Float4> values;          // [cells * blocks]
  std::vector<Float4> children;        // [4 * cells * blocks]: values between the centres of the cells
};

// Half the width and height that the texels without a sample have, if they fill a part of a cell from side to side.
struct Radius {
  float x, y;
};

constexpr std::uint32_t no_cell = ~std::uint32_t{0};

// What a solution on the coarse levels is: the values themselves, or a correction of values.
enum class Solution { values, correction };

class CoarseLevels {
 public:
  // Makes the levels down to a single cell. There must be a texel without a sample, and one with a sample next to it.
  void build(const StateMap& map);

  // The first coarse level. Its right sides are set to zero before each solution; the caller adds to them.
  Level& first() { return levels_.front(); }
  template <unsigned blocks>
  void clear_right_sides();
  // Solves all levels from the coarsest to the first: each starts from the coarser one, and is smoothed. The right sides
  // are the sums of the samples next to the texels of a cell, or the sums of its texels' residuals.
  template <unsigned blocks>
  void solve(Solution solution);

 private:
  std::vector<Level> levels_;  // kept with their memory; the first `used_` are in use
  std::size_t used_ = 0;
  std::vector<Radius> radii_;  // scratch memory
};

}  // namespace glark::maps
