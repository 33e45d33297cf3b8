// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vectors of three floats.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace glark::surfel {

struct Vector {
  float x = 0, y = 0, z = 0;

  float operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(Vector a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline bool operator==(Vector a, Vector b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline float dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vector a) { return std::sqrt(dot(a, a)); }
inline Vector least(Vector a, Vector b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
inline Vector greatest(Vector a, Vector b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
inline std::array<float, 3> to_array(Vector a) { return {a.x, a.y, a.z}; }
inline Vector to_vector(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }

// The length of a vector whose squared coordinates may overflow or underflow.
inline float length_of_any(Vector a) {
  const float size = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
  return size > 0 ? size * length({a.x / size, a.y / size, a.z / size}) : 0;
}

// The vector of length 1; zero stays zero. Squared coordinates may overflow or underflow.
inline Vector unit(Vector a) {
  const float squared = dot(a, a);
  constexpr float small = 1e-30F, large = 1e30F;
  if (squared > small && squared < large) return a * (1 / std::sqrt(squared));
  const float size = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
  if (!(size > 0)) return {};
  const Vector scaled = {a.x / size, a.y / size, a.z / size};
  return scaled * (1 / length(scaled));
}

// A unit vector that is perpendicular to the given unit vector.
inline Vector perpendicular(Vector normal) {
  const Vector along = std::fabs(normal.x) < 0.6F ? Vector{1, 0, 0} : Vector{0, 1, 0};
  return unit(cross(normal, along));
}

}  // namespace glark::surfel
