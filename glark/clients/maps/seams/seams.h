// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes the maps of neighbouring charts equal along the edges that they share.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "glark/clients/maps/charts/tangent_frame.h"

namespace glark::maps {

// An edge in one chart, from one end to the other. The ends are in texels: the centre of texel (i, j) is at
// (i + 0.5, j + 0.5). Ends outside the chart have the values of its border.
struct SeamSide {
  std::uint32_t chart = 0;
  std::array<float, 2> from{}, to{};
  unsigned least_side =
      0;  // the shorter side of the part of the chart that has this edge, with a gutter; 0: of the chart
};

// The two sides of an edge, in the same direction. They may lie in the same chart.
struct Seam {
  SeamSide a, b;
};

// What the shader interpolates along a seam, at its two ends.
struct SeamFrames {
  std::array<Vector, 2> normals;                  // the same on both sides
  std::array<std::array<Vector, 2>, 2> tangents;  // [side][end]
  bool is_hard = false;                           // the normals of both sides shall differ
};

// A chart's texels, row by row; the values of a texel lie together.
struct ChartImage {
  unsigned width = 0, height = 0;  // at least 1
  std::span<float> values;         // [channels * width * height], finite
};

// The weights are above 0, and compare with the difference along a seam.
struct SeamOptions {
  float samples_per_texel = 3;  // along a seam, of the side with more texels
  float fidelity = 1e-4F;       // the weight of a texel's change
  float smoothness = 1e-3F;     // the weight of the difference between the changes of two neighbouring texels
  unsigned levels = 1;          // mipmap levels that shall agree, the first one best
  float mip_fidelity = 0.3F;    // as `fidelity`, in the levels after the first one
  std::optional<unsigned> first_level_channel = {};  // a channel that shall agree in the first level only
};

// Differences of bilinear samples along all seams, for each channel.
struct SeamDifferences {
  std::vector<float> greatest, root_mean_square;  // [channels]
};

// Measures the differences of the two sides, eight samples a texel.
SeamDifferences seam_jumps(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams);

// Changes the texels next to seams, so that bilinear samples along a seam are the same on both sides. Texels farther away
// than the last level's filter stay. frames: [seams] if the first three channels are normals in tangent space, which are
// made the same in the space of the positions; otherwise empty. With several levels, the sides of charts must be multiples
// of two to the power of the last level.
void equalise(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
              const SeamOptions& options = {}, std::span<const SeamFrames> frames = {});

}  // namespace glark::maps
