// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The finest level of the multigrid solver: the texels themselves, for up to eight channels at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "glark/clients/maps/fill/coarse_levels.h"
#include "glark/clients/maps/fill/texel_blocks.h"
#include "glark/clients/maps/fill/texel_lists.h"

namespace glark::maps {

template <unsigned channels>
class FinestLevel {
 public:
  using Blocks = TexelBlocks<channels>;
  using Values = std::array<Float4, Blocks::count>;

  // values: the first channel of the first texel; `stride` floats from a texel to the next one.
  FinestLevel(float* values, std::size_t stride, const TexelLists& lists, std::span<const float> weights);

  // Gives texels without a sample whose neighbours all have one their mean.
  void fill_single();
  // Finds the range of the samples, which the other functions need.
  void find_range();
  // Adds the samples next to texels of a cell to the cell's right side.
  void restrict_samples(Level& level) const;
  // Adds the residuals of a cell's texels to its right side.
  void restrict_residuals(Level& level) const;
  // Gives texels the values of their cells.
  void set(const Level& level);
  // Adds the values of their cells to the texels', and keeps these within the range. Returns the greatest change,
  // relative to the range.
  float correct(const Level& level);
  // One sweep of Gauss and Seidel. The latter returns the greatest change, relative to the range.
  void smooth();
  float smooth_and_measure();

 private:
  float* at(std::uint32_t index) const { return values_ + index * stride_; }
  Float4 sum_around(const float* texel, unsigned block) const {
    return (Blocks::load(texel - stride_, block) + Blocks::load(texel + stride_, block)) +
           (Blocks::load(texel - row_, block) + Blocks::load(texel + row_, block));
  }
  // Calls visit(neighbour's index) for the neighbours within the raster. Returns their number.
  template <class Visit>
  unsigned for_neighbours(const BorderTexel& texel, const Visit& visit) const;
  template <bool is_measured>
  float sweep();
  float relative(const Values& change) const;

  float* values_;
  std::size_t stride_, row_;  // floats from a texel to the next one, and to the next row
  const TexelLists& lists_;
  std::span<const float> weights_;
  Values least_{}, greatest_{}, inverse_range_{};
};

}  // namespace glark::maps
