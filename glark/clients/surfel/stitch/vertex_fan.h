// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangles around a point, as sectors of its tangent plane.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "glark/clients/surfel/tree/vector.h"

namespace glark::surfel {

// Angles are positions on the diamond |x| + |y| = 1. They are cheaper than radians and have the same order. Opposite
// directions are half a turn apart.
inline constexpr float full_turn = 4;

inline float diamond_angle(float y, float x) {
  const float size = std::fabs(x) + std::fabs(y);
  if (!(size > 0)) return 0;
  const float right = y / size, left = (y >= 0 ? 2.0F : -2.0F) - right;
  return x >= 0 ? right : left;
}

// Returns an angle between 0 and a full turn.
inline float wrapped(float angle) { return angle < 0 ? angle + full_turn : angle; }

struct VertexFan {
  // The sector of one triangle. The triangle's other two corners name it, counter-clockwise.
  struct Sector {
    std::uint32_t first, second;
    float from, angle;  // angle < 0: the triangle is back-facing here
  };

  Vector position, normal, u, v;  // u and v span the tangent plane
  std::vector<Sector> sectors;

  void begin(Vector at, Vector unit_normal) {
    sectors.clear();
    position = at;
    normal = unit_normal;
    u = perpendicular(normal);
    v = cross(normal, u);
  }

  float angle_of(Vector point) const {
    const Vector d = point - position;
    return diamond_angle(dot(d, v), dot(d, u));
  }
};

}  // namespace glark::surfel
