// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seams/mip_levels.h"

#include <algorithm>
#include <cassert>

namespace glark::maps {
namespace {

// Calls visit(texel of the chart, texel of the level).
template <class Visit>
void for_each_texel(const ChartImage& chart, unsigned level, const Visit& visit) {
  const std::size_t width = chart.width >> level;
  for (std::size_t y = 0; y < chart.height; ++y)
    for (std::size_t x = 0; x < chart.width; ++x) visit(y * chart.width + x, (y >> level) * width + (x >> level));
}

SeamSide scaled(SeamSide side, unsigned level) {
  const float scale = 1 / static_cast<float>(1U << level);
  for (auto* end : {&side.from, &side.to})
    for (float& coordinate : *end) coordinate *= scale;
  return side;
}

}  // namespace

MipLevel::MipLevel(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
                   std::span<const SeamFrames> frames, unsigned level)
    : channels_(channels), level_(level) {
  const auto is_small = [&](const SeamSide& side) {
    constexpr unsigned least_side = 8;
    const unsigned of_chart = std::min(charts[side.chart].width, charts[side.chart].height);
    return (side.least_side > 0 ? side.least_side : of_chart) >> level < least_side;
  };
  for (std::size_t i = 0; i < seams.size(); ++i) {
    if (level > 0 && (is_small(seams[i].a) || is_small(seams[i].b))) continue;
    seams_.push_back({scaled(seams[i].a, level), scaled(seams[i].b, level)});
    if (!frames.empty()) frames_.push_back(frames[i]);
  }
  if (level == 0) {
    images_.assign(charts.begin(), charts.end());
    return;
  }
  values_.resize(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const ChartImage& chart = charts[i];
    assert(chart.width % (1U << level) == 0 && chart.height % (1U << level) == 0);
    values_[i].resize(chart.values.size() >> (2 * level));
    images_.push_back({chart.width >> level, chart.height >> level, values_[i]});
  }
}

void MipLevel::restrict_from(std::span<const ChartImage> charts) {
  const float part = 1 / static_cast<float>(1U << (2 * level_));
  for (std::size_t i = 0; i < values_.size(); ++i) {
    std::fill(values_[i].begin(), values_[i].end(), 0.0F);
    for_each_texel(charts[i], level_, [&](std::size_t from, std::size_t to) {
      for (unsigned c = 0; c < channels_; ++c)
        values_[i][to * channels_ + c] += part * charts[i].values[from * channels_ + c];
    });
  }
  before_ = values_;
}

void MipLevel::add_changes_to(std::span<const ChartImage> charts) const {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    for_each_texel(charts[i], level_, [&](std::size_t to, std::size_t from) {
      for (unsigned c = 0; c < channels_; ++c)
        charts[i].values[to * channels_ + c] += values_[i][from * channels_ + c] - before_[i][from * channels_ + c];
    });
  }
}

}  // namespace glark::maps
