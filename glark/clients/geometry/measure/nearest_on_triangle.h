// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "glark/clients/common/vector.h"

namespace glark::geometry {

using Vector = common::Vector3d;

// Returns the normal. Its length is twice the area.
inline Vector normal_of(const std::array<Vector, 3>& corners) {
  return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

inline double area_of(const std::array<Vector, 3>& corners) { return length(normal_of(corners)) / 2; }

inline double longest_edge(const std::array<Vector, 3>& corners) {
  return std::sqrt(std::max({squared_distance(corners[0], corners[1]), squared_distance(corners[1], corners[2]),
                             squared_distance(corners[2], corners[0])}));
}

inline Vector blend(const std::array<Vector, 3>& corners, const std::array<double, 3>& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

inline Vector nearest_on_segment(const Vector& from, const Vector& a, const Vector& b) {
  const Vector edge = b - a;
  const double square = dot(edge, edge);
  const double along = square > 0 ? std::clamp(dot(from - a, edge) / square, 0.0, 1.0) : 0;
  return a + along * edge;
}

// Returns the nearest point of the triangle. For a triangle without area, it is the nearest point on the edges.
inline Vector nearest_on_triangle(const Vector& from, const std::array<Vector, 3>& corners) {
  const Vector normal = normal_of(corners);
  const double square = dot(normal, normal);
  bool inside = square > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    const Vector& a = corners[i];
    const Vector& b = corners[(i + 1) % 3];
    inside = dot(cross(b - a, from - a), normal) >= 0;
  }
  if (inside) {
    const double height = dot(from - corners[0], normal) / square;
    return from - height * normal;
  }
  Vector best = nearest_on_segment(from, corners[0], corners[1]);
  for (std::size_t i = 1; i < 3; ++i) {
    const Vector other = nearest_on_segment(from, corners[i], corners[(i + 1) % 3]);
    if (squared_distance(from, other) < squared_distance(from, best)) best = other;
  }
  return best;
}

}  // namespace glark::geometry
