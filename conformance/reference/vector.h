// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Vectors in double precision: compared with the judged values, the reference is exact.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace glark::conformance::reference {

struct Vector {
  double x = 0;
  double y = 0;
  double z = 0;
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vector operator/(const Vector& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Has unit length, unless it is zero.
inline Vector direction(const Vector& a) { return length(a) > 0 ? a / length(a) : a; }

template <std::size_t n>
Vector vector_of(const std::array<float, n>& a) {
  static_assert(n >= 3);
  return {a[0], a[1], a[2]};
}

}  // namespace glark::conformance::reference
