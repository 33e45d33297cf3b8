// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/chart_map.h"

#include <algorithm>
#include <cmath>

namespace glark::maps {

void ChartMap::add(Point2 texel, std::span<const float> sample) {
  const float x = std::clamp(texel[0] - 0.5F, 0.0F, static_cast<float>(width) - 1.001F);
  const float y = std::clamp(texel[1] - 0.5F, 0.0F, static_cast<float>(height) - 1.001F);
  const auto i = static_cast<std::size_t>(x);
  const auto j = static_cast<std::size_t>(y);
  const float fx = x - static_cast<float>(i);
  const float fy = y - static_cast<float>(j);
  const auto add_to = [&](std::size_t at, float weight) {
    float* texel_values = values.data() + at * sample.size();
    for (std::size_t k = 0; k < sample.size(); ++k) texel_values[k] += weight * sample[k];
    weights[at] += weight;
  };
  const std::size_t at = j * width + i;
  add_to(at, (1 - fx) * (1 - fy));
  add_to(at + 1, fx * (1 - fy));
  add_to(at + width, (1 - fx) * fy);
  add_to(at + width + 1, fx * fy);
}

void ChartMap::divide(unsigned channels) {
  constexpr float least_weight = 0.2499F;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] < least_weight) weights[i] = 0;
    const float inverse = weights[i] > 0 ? 1 / weights[i] : 0;
    for (unsigned k = 0; k < channels; ++k) values[i * channels + k] *= inverse;
  }
}

}  // namespace glark::maps
