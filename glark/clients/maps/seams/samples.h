// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Bilinear samples along the two sides of a seam.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "glark/clients/maps/seams/seams.h"

namespace glark::maps {

// The four texels of a bilinear sample, and their weights. On the border of a chart, a texel may occur twice.
struct BilinearSample {
  std::array<std::size_t, 4> texels;
  std::array<float, 4> weights;
};

inline BilinearSample sample_at(const ChartImage& chart, float x, float y) {
  struct Axis {
    std::size_t before, after;
    float part;
  };
  const auto axis = [](float position, unsigned size) {
    const float inside = std::clamp(position - 0.5F, 0.0F, static_cast<float>(size - 1));
    const auto before = std::min(static_cast<std::size_t>(inside), std::size_t{size} - 1);
    return Axis{before, std::min(before + 1, std::size_t{size} - 1), inside - static_cast<float>(before)};
  };
  const Axis column = axis(x, chart.width), row = axis(y, chart.height);
  const std::size_t lower = row.before * chart.width, upper = row.after * chart.width;
  return {{lower + column.before, lower + column.after, upper + column.before, upper + column.after},
          {(1 - column.part) * (1 - row.part), column.part * (1 - row.part), (1 - column.part) * row.part,
           column.part * row.part}};
}

inline BilinearSample sample_at(const ChartImage& chart, const SeamSide& side, float t) {
  return sample_at(chart, side.from[0] + (side.to[0] - side.from[0]) * t,
                   side.from[1] + (side.to[1] - side.from[1]) * t);
}

inline float length(const SeamSide& side) { return std::hypot(side.to[0] - side.from[0], side.to[1] - side.from[1]); }

// Calls visit(part of the way, sample of a, sample of b) along the seam, both ends included.
template <class Visit>
void for_samples(std::span<const ChartImage> charts, const Seam& seam, float samples_per_texel, const Visit& visit) {
  const float texels = std::max(length(seam.a), length(seam.b));
  const auto steps = static_cast<std::size_t>(std::ceil(texels * samples_per_texel));
  for (std::size_t i = 0; i <= steps; ++i) {
    const float t = steps == 0 ? 0.0F : static_cast<float>(i) / static_cast<float>(steps);
    visit(t, sample_at(charts[seam.a.chart], seam.a, t), sample_at(charts[seam.b.chart], seam.b, t));
  }
}

// Calls visit(seam, part of the way, sample of a, sample of b) for all samples, in the order of the seams.
template <class Visit>
void for_all_samples(std::span<const ChartImage> charts, std::span<const Seam> seams, float samples_per_texel,
                     const Visit& visit) {
  for (std::size_t i = 0; i < seams.size(); ++i)
    for_samples(charts, seams[i], samples_per_texel,
                [&](float part, const BilinearSample& a, const BilinearSample& b) { visit(i, part, a, b); });
}

}  // namespace glark::maps
