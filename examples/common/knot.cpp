// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "examples/common/knot.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace lesson {
namespace {

using Vector = std::array<float, 3>;

Vector normalized(const Vector& v) {
  const float length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The middle line of the knot.
Vector curve(float t) {
  const float r = 1 + 0.35F * std::cos(3 * t);
  return {r * std::cos(2 * t), r * std::sin(2 * t), 0.45F * std::sin(3 * t)};
}

}  // namespace

Points make_knot(int count) {
  constexpr float turn = 6.2831853F, thickness = 0.32F;
  Points points;
  for (int i = 0; i < count; ++i) {
    const float along = turn * std::fmod(float(i) * 0.7548777F, 1.0F);
    const float around = turn * std::fmod(float(i) * 0.5698403F, 1.0F);
    const Vector middle = curve(along), ahead = curve(along + 0.01F);
    const Vector tangent = normalized({ahead[0] - middle[0], ahead[1] - middle[1], ahead[2] - middle[2]});
    const Vector up = normalized(cross(tangent, {std::cos(2 * along), std::sin(2 * along), 0}));
    const Vector across = cross(up, tangent);
    for (std::size_t k = 0; k < 3; ++k) {
      const float normal = std::cos(around) * across[k] + std::sin(around) * up[k];
      points.normals.push_back(normal);
      points.positions.push_back(middle[k] + thickness * normal);
    }
  }
  return points;
}

}  // namespace lesson
