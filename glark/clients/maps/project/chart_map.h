// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the points say about the texels of a chart.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "glark/clients/maps/atlas/atlas.h"

namespace glark::maps {

// The values of a texel: the normal, the height, and the colour if there is one. Normals are in the space of the positions
// until the maps are filled, then in tangent space.
inline constexpr unsigned normal_channel = 0;
inline constexpr unsigned height_channel = 3;
inline constexpr unsigned colour_channel = 4;
inline constexpr unsigned channels_without_colour = 4;
inline constexpr unsigned channels_with_colour = 7;

struct ChartMap {
  unsigned width = 0, height = 0;
  std::vector<float> values;   // [channels * width * height]: sums over the points, or their means
  std::vector<float> weights;  // [width * height]: the weight of the points at each texel
  bool is_changed = false;     // since the map was saved

  void resize(const Place& place, unsigned channels) {
    width = place.width;
    height = place.height;
    values.assign(std::size_t{channels} * width * height, 0.0F);
    weights.assign(std::size_t{width} * height, 0.0F);
  }
  void clear() {
    std::fill(values.begin(), values.end(), 0.0F);
    std::fill(weights.begin(), weights.end(), 0.0F);
  }
  // Adds the values to the four texels around a place, by the weights of bilinear filtering.
  void add(Point2 texel, std::span<const float> sample);
  // Turns sums into means. A texel whose weight is less than a point's at the corner of four texels has no point.
  void divide(unsigned channels);
};

}  // namespace glark::maps
