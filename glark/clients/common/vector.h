// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points and vectors of three coordinates. float4.h has the vectors for loops that use vector instructions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace glark::common {

template <class Scalar>
struct Vector3 {
  Scalar x = 0, y = 0, z = 0;

  constexpr Scalar operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr Scalar& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

using Vector3f = Vector3<float>;
using Vector3d = Vector3<double>;

template <class Scalar>
constexpr Vector3<Scalar> operator+(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Scalar>
constexpr Vector3<Scalar> operator-(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Scalar>
constexpr Vector3<Scalar> operator*(Vector3<Scalar> a, Scalar s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Scalar>
constexpr Vector3<Scalar> operator*(Scalar s, Vector3<Scalar> a) {
  return a * s;
}
template <class Scalar>
constexpr Vector3<Scalar>& operator+=(Vector3<Scalar>& a, Vector3<Scalar> b) {
  return a = a + b;
}

template <class Scalar>
constexpr Scalar dot(Vector3<Scalar> a, Vector3<Scalar> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Scalar>
constexpr Vector3<Scalar> cross(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Scalar>
constexpr Vector3<Scalar> least(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <class Scalar>
constexpr Vector3<Scalar> greatest(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

template <class Scalar>
constexpr bool is_zero(Vector3<Scalar> a) {
  return a == Vector3<Scalar>{};
}

// The squared length must neither overflow nor underflow. robust_length() has no such limit, but is slower.
template <class Scalar>
Scalar length(Vector3<Scalar> a) {
  return std::sqrt(dot(a, a));
}
template <class Scalar>
Scalar robust_length(Vector3<Scalar> a) {
  return std::hypot(a.x, a.y, a.z);
}
template <class Scalar>
Scalar squared_distance(Vector3<Scalar> a, Vector3<Scalar> b) {
  return dot(a - b, a - b);
}

// Returns the vector with length 1. The vector may have any length. Zero, infinity and NaN give zero.
template <class Scalar>
Vector3<Scalar> unit(Vector3<Scalar> a) {
  const Scalar squared = dot(a, a);
  constexpr Scalar small = static_cast<Scalar>(1e-30), large = static_cast<Scalar>(1e30);
  if (squared > small && squared < large) return a * (1 / std::sqrt(squared));
  const Scalar size = std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  if (!(size > 0 && size <= std::numeric_limits<Scalar>::max())) return {};
  const Vector3<Scalar> scaled = {a.x / size, a.y / size, a.z / size};
  return scaled * (1 / length(scaled));
}

// Returns a unit vector perpendicular to `normal`, which has unit length.
template <class Scalar>
Vector3<Scalar> perpendicular(Vector3<Scalar> normal) {
  const Vector3<Scalar> along =
      std::abs(normal.x) < static_cast<Scalar>(0.6) ? Vector3<Scalar>{1, 0, 0} : Vector3<Scalar>{0, 1, 0};
  return unit(cross(normal, along));
}

template <class Scalar>
constexpr std::array<Scalar, 3> to_array(Vector3<Scalar> a) {
  return {a.x, a.y, a.z};
}
template <class Scalar>
constexpr Vector3<Scalar> to_vector(const std::array<Scalar, 3>& a) {
  return {a[0], a[1], a[2]};
}
// Element `index` of an array that has three numbers for each element.
template <class Scalar>
constexpr Vector3<Scalar> vector_at(std::span<const Scalar> array, std::size_t index) {
  return {array[3 * index], array[3 * index + 1], array[3 * index + 2]};
}

}  // namespace glark::common
