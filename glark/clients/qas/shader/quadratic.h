// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Repeats the computation of refine.glsl, operation by operation.
#pragma once

#include <array>

#include "glark/clients/qas/float4.h"

namespace glark::qas {

// points: at the corners 0, 1, 2, then in the middle of the edges 01, 12, 20.
inline Float4 quadratic(const std::array<Float4, 6>& points, const std::array<float, 3>& barycentric) {
  const auto [w, u, v] = barycentric;
  const Float4 corners =
      ((w * (2 * w - 1)) * points[0] + (u * (2 * u - 1)) * points[1]) + (v * (2 * v - 1)) * points[2];
  const Float4 edges = ((4 * (w * u)) * points[3] + (4 * (u * v)) * points[4]) + (4 * (v * w)) * points[5];
  return corners + edges;
}

}  // namespace glark::qas
