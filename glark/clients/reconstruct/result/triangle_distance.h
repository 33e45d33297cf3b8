// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "glark/clients/common/float4.h"

namespace glark::reconstruct {

inline float squared_distance_to_segment(common::Float4 from, common::Float4 a, common::Float4 b) {
  const common::Float4 along = b - a;
  const float square = dot(along, along);
  const float part = square > 0 ? std::clamp(dot(from - a, along) / square, 0.0F, 1.0F) : 0.0F;
  const common::Float4 apart = from - a - along * part;
  return dot(apart, apart);
}

inline float squared_distance_to_triangle(common::Float4 from, common::Float4 a, common::Float4 b, common::Float4 c) {
  const common::Float4 normal = cross(b - a, c - a);
  const float square = dot(normal, normal);
  const bool is_above = square > 0 && dot(cross(b - a, from - a), normal) >= 0 &&
                        dot(cross(c - b, from - b), normal) >= 0 && dot(cross(a - c, from - c), normal) >= 0;
  if (is_above) {
    const float height = dot(from - a, normal);
    return height * height / square;
  }
  return std::min({squared_distance_to_segment(from, a, b), squared_distance_to_segment(from, b, c),
                   squared_distance_to_segment(from, c, a)});
}

}  // namespace glark::reconstruct
