// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "glark/clients/depth/state.h"
#include "glark/clients/depth/validation.h"

namespace glark::depth {
namespace {

constexpr int morph_steps = 64;  // steps per level with GL_GEOMORPH_ARK
constexpr int morph_lift = 3;    // up to this depth, one shallow edge does not make the interior shallow
constexpr int bias_steps = 256;

int edge_depth(float a, float b, EdgeRule rule) {
  if (rule == EdgeRule::rounded) {
    return (static_cast<int>(std::floor(a + 0.5F)) + static_cast<int>(std::floor(b + 0.5F))) / 2;
  }
  const auto steps = [](float tag) { return static_cast<int>(std::floor(tag * morph_steps + 0.5F)); };
  return ((steps(a) + steps(b)) / 2 + morph_steps - 1) / morph_steps;
}

// Returns the number of triangles of a pattern. A triangulation of b points on the boundary and i points inside has 2 i
// + b - 2 triangles. The points inside are those of a lattice of 2^inner segments.
// Usually `inner` is the least depth. With geomorphing, it is the second least depth, at most 3, unless the least depth
// is greater. Then an interior of depth 0 or 1 has one point, unless no edge is divided.
std::uint64_t triangles_of(int d0, int d1, int d2, EdgeRule rule) {
  const int least = std::min({d0, d1, d2});
  const std::uint64_t border = (std::uint64_t{1} << d0) + (std::uint64_t{1} << d1) + (std::uint64_t{1} << d2);
  const int middle = std::max(std::min(d0, d1), std::min(std::max(d0, d1), d2));
  const int inner = rule == EdgeRule::geomorph ? std::max(least, std::min(middle, morph_lift)) : least;
  if (rule == EdgeRule::geomorph && inner < 2) return border == 3 ? 1 : border;
  const std::uint64_t n = std::uint64_t{1} << inner;
  return (n - 1) * (n - 2) + border - 2;
}

}  // namespace

std::uint64_t Tagger::count_refined(std::span<const float> tags, float bias, EdgeRule rule) const {
  const std::vector<std::uint32_t>& triangles = state_->triangles;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const float a = clamped(tags[triangles[i]] - bias);
    const float b = clamped(tags[triangles[i + 1]] - bias);
    const float c = clamped(tags[triangles[i + 2]] - bias);
    sum += triangles_of(edge_depth(a, b, rule), edge_depth(b, c, rule), edge_depth(c, a, rule), rule);
  }
  return sum;
}

std::uint64_t Tagger::refined_triangles(std::span<const float> tags, EdgeRule rule) const {
  check_tags("the tag", tags, vertices_);
  return count_refined(tags, 0.0F, rule);
}

// Lower tags never give more triangles, so the least bias is found by bisection.
Budget Tagger::keep_budget(std::uint64_t triangles, std::span<float> tags, EdgeRule rule) const {
  check_tags("the tag", tags, vertices_);
  const auto count_at = [&](int steps) { return count_refined(tags, static_cast<float>(steps) / bias_steps, rule); };
  int enough = 0;
  std::uint64_t count = count_at(0);
  if (count > triangles) {
    int too_little = 0;
    enough = static_cast<int>(max_level_) * bias_steps + 1;
    for (float tag : tags) enough = std::max(enough, static_cast<int>(std::min(tag, 1e4F)) * bias_steps + bias_steps);
    count = count_at(enough);
    while (enough - too_little > 1 && count <= triangles) {
      const int middle = too_little + (enough - too_little) / 2;
      const std::uint64_t there = count_at(middle);
      if (there <= triangles) {
        enough = middle;
        count = there;
      } else {
        too_little = middle;
      }
    }
  }
  Budget result{static_cast<float>(enough) / bias_steps, count, count <= triangles};
  for (float& tag : tags) tag = clamped(tag - result.bias);
  return result;
}

}  // namespace glark::depth
