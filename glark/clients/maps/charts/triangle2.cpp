// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/triangle2.h"

#include <limits>

namespace glark::maps {
namespace {

// The place of an edge that is nearest to a point, as a part of the way from a to b.
float nearest_on_edge(Point2 a, Point2 b, Point2 p) {
  const Point2 edge{b[0] - a[0], b[1] - a[1]};
  const float squared = edge[0] * edge[0] + edge[1] * edge[1];
  if (!(squared > 0)) return 0;
  return std::clamp(((p[0] - a[0]) * edge[0] + (p[1] - a[1]) * edge[1]) / squared, 0.0F, 1.0F);
}

}  // namespace

std::pair<Weights, float> nearest_on_boundary(const Triangle2& triangle, Point2 p) {
  Weights best{1, 0, 0};
  float least = std::numeric_limits<float>::max();
  for (std::size_t k = 0; k < 3; ++k) {
    Weights w{};
    const float part = nearest_on_edge(triangle.corners[k], triangle.corners[(k + 1) % 3], p);
    w[k] = 1 - part;
    w[(k + 1) % 3] = part;
    const Point2 at = triangle.at(w);
    const float squared = (at[0] - p[0]) * (at[0] - p[0]) + (at[1] - p[1]) * (at[1] - p[1]);
    if (squared >= least) continue;
    least = squared;
    best = w;
  }
  return {best, least};
}

}  // namespace glark::maps
