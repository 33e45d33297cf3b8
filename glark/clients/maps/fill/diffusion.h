// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Fills the texels of a chart that have no sample, by diffusion of the samples around them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "glark/clients/maps/fill/coarse_levels.h"
#include "glark/clients/maps/fill/gradients.h"
#include "glark/clients/maps/fill/texel_lists.h"

namespace glark::maps {

// The texels of one chart, row by row; the values of a texel lie together.
struct Raster {
  unsigned width = 0, height = 0, channels = 0;  // at least 1
  std::span<float> values;                       // [channels * width * height]; finite where a texel has a sample
  std::span<const float> weights;                // [width * height]; above 0: the texel has a sample, which is kept
};

struct DiffusionOptions {
  float tolerance = 1e-3F;       // of the last cycle's changes, relative to the range of the channel's samples
  unsigned max_iterations = 50;  // at least 1
};

struct Diffusion {
  std::size_t filled = 0;       // texels that had no sample, and have values now
  unsigned iterations = 0;      // multigrid cycles; 0 where no texel without a sample has a neighbour without one
  unsigned gradient_steps = 0;  // of conjugate gradients, where multigrid did not converge
};

// Keeps its memory, so that filling many charts does not allocate. Each thread needs an object of its own.
class Diffuser {
 public:
  // Replaces the values of the texels without a sample. Each becomes the mean of its neighbours; the border of the
  // raster reflects. The filled values lie within the range of the samples. Without any sample, all values become 0.
  Diffusion fill(const Raster& raster, const DiffusionOptions& options = {});

 private:
  TexelLists lists_;
  CoarseLevels levels_;
  Gradients gradients_;
};

// The same, for a single chart.
Diffusion diffuse(const Raster& raster, const DiffusionOptions& options = {});

}  // namespace glark::maps
