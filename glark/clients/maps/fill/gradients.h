// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Diffusion by conjugate gradients. It is slower than the multigrid solver, and converges always. Where few samples lie
// far apart, the coarse levels cannot see them, so multigrid cycles make the values worse.
// Source: M. Hestenes, E. Stiefel, Methods of Conjugate Gradients for Solving Linear Systems, 1952.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/clients/common/float4.h"
#include "glark/clients/maps/fill/texel_lists.h"

namespace glark::maps {

struct Raster;

class Gradients {
 public:
  // Improves the values of the texels of `lists` that are inside or on the border, in up to four channels from `first`
  // on, until no step changes a value by more than `tolerance` times the channel's range of samples, or the values do
  // not improve any more. The values must be finite. Returns the number of steps.
  unsigned improve(const Raster& raster, unsigned first, const TexelLists& lists, float tolerance);

 private:
  using Float4 = common::Float4;

  void load(const Raster& raster, unsigned first, const TexelLists& lists);
  void store(const Raster& raster, unsigned first) const;
  // The neighbours' sum, and their number.
  Float4 around(const std::vector<Float4>& values, std::uint32_t texel, float& count) const;

  std::uint32_t width_ = 0;
  unsigned channels_ = 0;                 // that are solved, at most 4
  std::vector<std::uint32_t> texels_;     // those without a sample
  std::vector<Float4> values_;            // [texels of the raster]
  std::vector<Float4> direction_;         // the same; 0 at samples
  std::vector<Float4> residual_, image_;  // [texels_]: of the equations, and of the direction
  Float4 least_{}, greatest_{};
};

}  // namespace glark::maps
