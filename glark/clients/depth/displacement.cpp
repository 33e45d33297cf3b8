// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "glark/clients/depth/state.h"
#include "glark/clients/depth/validation.h"

namespace glark::depth {
namespace {

constexpr int fewest_samples = 8;  // minimum number of samples on the longest edge
constexpr int most_samples = 128;

struct Point {
  float u, v;
};

// Texels lie at the middles of cells, as in a texture of GL.
float height_at(const HeightMap& map, float u, float v) {
  const auto wrapped = [](float t, std::uint32_t size) {
    const float scaled = (t - std::floor(t)) * static_cast<float>(size) - 0.5F;
    return scaled < 0 ? scaled + static_cast<float>(size) : scaled;
  };
  const float x = wrapped(u, map.width);
  const float y = wrapped(v, map.height);
  const std::uint32_t column = std::min(static_cast<std::uint32_t>(x), map.width - 1);
  const std::uint32_t row = std::min(static_cast<std::uint32_t>(y), map.height - 1);
  const auto texel = [&](std::uint32_t i, std::uint32_t j) {
    return map.heights[std::size_t{j % map.height} * map.width + i % map.width];
  };
  const float right = x - static_cast<float>(column);
  const float up = y - static_cast<float>(row);
  return (1 - up) * ((1 - right) * texel(column, row) + right * texel(column + 1, row)) +
         up * ((1 - right) * texel(column, row + 1) + right * texel(column + 1, row + 1));
}

// Returns the mean squared difference between the map and the linear interpolation of the corners. The longest side has
// one sample per texel.
double variance_within(const HeightMap& map, const Point corner[3]) {
  float texels = 0;
  float height[3];
  for (int k = 0; k < 3; ++k) {
    const Point& next = corner[(k + 1) % 3];
    texels = std::max({texels, std::abs(next.u - corner[k].u) * static_cast<float>(map.width),
                       std::abs(next.v - corner[k].v) * static_cast<float>(map.height)});
    height[k] = height_at(map, corner[k].u, corner[k].v);
  }
  const int n =
      static_cast<int>(std::clamp(texels, static_cast<float>(fewest_samples), static_cast<float>(most_samples)));
  double sum = 0;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i + j <= n; ++i) {
      const float b = static_cast<float>(i) / static_cast<float>(n);
      const float c = static_cast<float>(j) / static_cast<float>(n);
      const float a = 1 - b - c;
      const float height_there = height_at(map, a * corner[0].u + b * corner[1].u + c * corner[2].u,
                                           a * corner[0].v + b * corner[1].v + c * corner[2].v);
      const double difference = height_there - (a * height[0] + b * height[1] + c * height[2]);
      sum += difference * difference;
    }
  }
  return sum / (0.5 * (n + 1) * (n + 2));
}

void check_map(const HeightMap& map) {
  require(map.width > 0 && map.height > 0 && map.heights.size() == std::size_t{map.width} * map.height,
          "a height map of {} by {} needs as many heights, above 0; there are {}", map.width, map.height,
          map.heights.size());
  const auto bad = std::find_if(map.heights.begin(), map.heights.end(), [](float h) { return !std::isfinite(h); });
  require(bad == map.heights.end(), "height {} of the map is not a finite number", bad - map.heights.begin());
}

}  // namespace

void Tagger::by_displacement(std::span<const float> coordinates, const HeightMap& map, float tolerance,
                             std::span<float> tags) {
  check_target(tags, vertices_);
  check_length("the array of texture coordinates", coordinates.size(), vertices_, 2);
  check_finite("the texture coordinate", coordinates, 2);
  check_map(map);
  require(tolerance > 0, "the tolerance {} is not above 0", tolerance);
  // A vertex gets the mean over the triangles around it, weighted by their area in the map.
  const std::vector<std::uint32_t>& triangles = state_->triangles;
  std::vector<float>&sums = state_->longest, &areas = state_->areas;
  std::fill(sums.begin(), sums.end(), 0.0F);
  std::fill(areas.begin(), areas.end(), 0.0F);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    Point corner[3];
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = {coordinates[2 * triangles[i + k]], coordinates[2 * triangles[i + k] + 1]};
    const float area = 0.5F * std::abs((corner[1].u - corner[0].u) * (corner[2].v - corner[0].v) -
                                       (corner[1].v - corner[0].v) * (corner[2].u - corner[0].u));
    const auto variance = static_cast<float>(variance_within(map, corner));
    for (std::size_t k = 0; k < 3; ++k) {
      sums[triangles[i + k]] += area * variance;
      areas[triangles[i + k]] += area;
    }
  }
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const float deviation = areas[vertex] > 0 ? std::sqrt(sums[vertex] / areas[vertex]) : 0.0F;
    tags[vertex] = clamped(std::log2(std::max(deviation / tolerance, 1.0F)));
  }
}

}  // namespace glark::depth
