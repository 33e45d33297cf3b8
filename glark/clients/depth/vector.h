// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Three floats in space.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include <glark/depth.h>

namespace glark::tagging {

inline Vector vector_at(std::span<const float> array, std::size_t vertex) {
  return {array[3 * vertex], array[3 * vertex + 1], array[3 * vertex + 2]};
}
inline Vector plus(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector times(float s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline float dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline float length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// Of length 1, or 0 where there is no direction.
inline Vector unit(const Vector& a) {
  const float size = length(a);
  return size > 0 && std::isfinite(size) ? times(1 / size, a) : Vector{};
}

}  // namespace glark::tagging
