// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace glark::geometry {

using Vector = std::array<double, 3>;

inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double square_distance(const Vector& a, const Vector& b) { return dot(minus(a, b), minus(a, b)); }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Twice the area long.
inline Vector normal_of(const std::array<Vector, 3>& corners) {
  return cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
}

inline double area_of(const std::array<Vector, 3>& corners) {
  const Vector normal = normal_of(corners);
  return std::sqrt(dot(normal, normal)) / 2;
}

inline double longest_edge(const std::array<Vector, 3>& corners) {
  return std::sqrt(std::max({square_distance(corners[0], corners[1]), square_distance(corners[1], corners[2]),
                             square_distance(corners[2], corners[0])}));
}

inline Vector blend(const std::array<Vector, 3>& corners, const std::array<double, 3>& weights) {
  Vector sum{};
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += weights[corner] * corners[corner][axis];
  return sum;
}

inline Vector nearest_on_segment(const Vector& from, const Vector& a, const Vector& b) {
  const Vector edge = minus(b, a);
  const double length = dot(edge, edge);
  const double along = length > 0 ? std::clamp(dot(minus(from, a), edge) / length, 0.0, 1.0) : 0;
  return {a[0] + along * edge[0], a[1] + along * edge[1], a[2] + along * edge[2]};
}

// Of a triangle without area: on its edges.
inline Vector nearest_on_triangle(const Vector& from, const std::array<Vector, 3>& corners) {
  const Vector normal = normal_of(corners);
  const double square = dot(normal, normal);
  bool inside = square > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    const Vector& a = corners[i];
    const Vector& b = corners[(i + 1) % 3];
    inside = dot(cross(minus(b, a), minus(from, a)), normal) >= 0;
  }
  if (inside) {
    const double height = dot(minus(from, corners[0]), normal) / square;
    return {from[0] - height * normal[0], from[1] - height * normal[1], from[2] - height * normal[2]};
  }
  Vector best = nearest_on_segment(from, corners[0], corners[1]);
  for (std::size_t i = 1; i < 3; ++i) {
    const Vector other = nearest_on_segment(from, corners[i], corners[(i + 1) % 3]);
    if (square_distance(from, other) < square_distance(from, best)) best = other;
  }
  return best;
}

}  // namespace glark::geometry
