// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The whole numbers that the maps of a model store.
#pragma once

#include <glark/maps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "glark/clients/maps/project/chart_map.h"

namespace glark::maps {

inline constexpr std::array<std::uint8_t, 3> flat_normal{128, 128, 255};  // of texels that no chart has

inline std::uint8_t byte_of(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255));
}

// A normal of the map. It keeps its length if it can be stored: lengths that differ from 1 make both sides of a seam agree
// after filtering, and the shader scales the sum to unit length.
inline Vector limited(Vector local) {
  if (common::is_zero(local)) return {0, 0, 1};
  return local * (1 / std::max({1.0F, std::abs(local.x), std::abs(local.y), std::abs(local.z)}));
}

// The range of the heights in the displacement map.
class Heights {
 public:
  void add(float height) {
    low_ = std::min(low_, height);
    high_ = std::max(high_, height);
  }
  float bias() const { return low_; }
  float scale() const { return high_ - low_; }
  std::uint16_t code_of(float height) const {
    if (!(scale() > 0)) return 0;
    const double part = (static_cast<double>(height) - static_cast<double>(bias())) / static_cast<double>(scale());
    return static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0, 1.0) * 65535));
  }

 private:
  float low_ = std::numeric_limits<float>::max(), high_ = std::numeric_limits<float>::lowest();
};

// Makes maps without any chart.
inline void clear_maps(unsigned width, unsigned height, bool has_colours, const Heights& heights, Baked& model) {
  model.width = width;
  model.height = height;
  model.bias = heights.bias();
  model.scale = heights.scale();
  const std::size_t texels = std::size_t{width} * height;
  model.normal_map.resize(3 * texels);
  for (std::size_t i = 0; i < model.normal_map.size(); ++i) model.normal_map[i] = flat_normal.at(i % 3);
  if (has_colours) model.colour_map.assign(3 * texels, 128);
  model.displacement_map.assign(texels, heights.code_of(0));
}

// values: of a texel, as in ChartMap. y_factor: -1 where the texture is mirrored.
inline void set_texel(const float* values, float y_factor, const Heights& heights, std::size_t at, Baked& model) {
  const Vector normal = limited({values[0], y_factor * values[1], values[2]});
  for (std::size_t k = 0; k < 3; ++k) model.normal_map[3 * at + k] = byte_of(normal[k] / 2 + 0.5F);
  model.displacement_map[at] = heights.code_of(values[height_channel]);
  if (!model.colour_map.empty())
    for (std::size_t k = 0; k < 3; ++k) model.colour_map[3 * at + k] = byte_of(values[colour_channel + k]);
}

}  // namespace glark::maps
