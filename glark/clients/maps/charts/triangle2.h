// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles in the plane of a chart, and the cells of a grid that they cover.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

using Weights = std::array<float, 3>;  // barycentric coordinates: their sum is 1

struct Triangle2 {
  std::array<Point2, 3> corners{};

  float doubled_area() const {
    return (corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
           (corners[2][0] - corners[0][0]) * (corners[1][1] - corners[0][1]);
  }
  // The triangle has an area.
  Weights weights_of(Point2 p) const {
    const float inverse = 1 / doubled_area();
    const Point2 d{p[0] - corners[0][0], p[1] - corners[0][1]};
    const float w1 = (d[0] * (corners[2][1] - corners[0][1]) - (corners[2][0] - corners[0][0]) * d[1]) * inverse;
    const float w2 = ((corners[1][0] - corners[0][0]) * d[1] - d[0] * (corners[1][1] - corners[0][1])) * inverse;
    return {1 - w1 - w2, w1, w2};
  }
  Point2 at(const Weights& w) const {
    return {w[0] * corners[0][0] + w[1] * corners[1][0] + w[2] * corners[2][0],
            w[0] * corners[0][1] + w[1] * corners[1][1] + w[2] * corners[2][1]};
  }
};

// Returns the weights of the place of a triangle's boundary that is nearest to a point, and the squared distance.
std::pair<Weights, float> nearest_on_boundary(const Triangle2& triangle, Point2 p);

// Calls visit(x, y, weights) for each cell (x, y) of side 1 whose centre has weights of at least `least`.
template <class Visit>
void for_each_centre(const Triangle2& triangle, float least, const Visit& visit) {
  if (!(std::abs(triangle.doubled_area()) > 1e-12F)) return;
  const auto& c = triangle.corners;
  const auto [low_x, high_x] = std::minmax({c[0][0], c[1][0], c[2][0]});
  const auto [low_y, high_y] = std::minmax({c[0][1], c[1][1], c[2][1]});
  for (int y = static_cast<int>(std::floor(low_y - 0.5F)); y <= static_cast<int>(std::ceil(high_y)); ++y) {
    for (int x = static_cast<int>(std::floor(low_x - 0.5F)); x <= static_cast<int>(std::ceil(high_x)); ++x) {
      const Weights w = triangle.weights_of({static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F});
      if (w[0] >= least && w[1] >= least && w[2] >= least) visit(x, y, w);
    }
  }
}

}  // namespace glark::maps
