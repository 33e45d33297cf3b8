// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How the normals of two samples of a surface agree.
#pragma once

#include <algorithm>

#include "glark/clients/common/points/record.h"

namespace glark::vstree {

using namespace common;  // Float4

struct Agreement {
  float flat;   // the cosine of the normals, where an arc connects the samples
  float sides;  // the same, but samples on top of one another are on the two sides of a wall or of a gap
  float slope;  // the squared sine of the greater slope of the way between the samples
};

// Reflects one normal at the plane half way between the samples. On an arc it is then equal to the other normal.
// Based on: H. Xie et al., Piecewise C1 Continuous Surface Reconstruction of Noisy Point Clouds via Local Implicit
// Quadric Regression, 2003, section 3.1.
inline Agreement agreement(Float4 way, Float4 a, Float4 b) {
  const float square = dot(way, way), share = square > 0 ? 1 / square : 0;
  const float along_a = dot(way, a), along_b = dot(way, b), product = along_a * along_b * share, cosine = dot(a, b);
  return {.flat = std::clamp(cosine - 2 * product, -1.0F, 1.0F),
          .sides = std::clamp(cosine - 3 * product, -1.0F, 1.0F),
          .slope = std::max(along_a * along_a, along_b * along_b) * share};
}

}  // namespace glark::vstree
