// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The quartic through the 15 points of a triangle whose barycentric coordinates are multiples of 1/4. The code repeats
// the computation of quartic.glsl, operation by operation.
#pragma once

#include <array>
#include <span>

#include "glark/clients/qas/float4.h"

namespace glark::qas {

// The points of one corner: the corner, the points at 1/4, 2/4 and 3/4 of the edge to the next corner, and the inner
// point next to the corner.
struct QuarticPoints {
  std::array<Float4, 4> edge;
  Float4 inner;
};

// Weight n is 1 where x is n/4, and 0 at smaller multiples of 1/4.
inline std::array<float, 5> quartic_weights(float x) {
  const float x4 = 4 * x;
  const float second = 0.5F * x4 * (x4 - 1);
  const float third = second * (x4 - 2) / 3;
  return {1, x4, second, third, third * (x4 - 3) / 4};
}

inline Float4 quartic(const std::array<QuarticPoints, 3>& corners, const std::array<float, 3>& barycentric) {
  const std::array<float, 5> w = quartic_weights(barycentric[0]), u = quartic_weights(barycentric[1]),
                             v = quartic_weights(barycentric[2]);
  const auto edge = [](const QuarticPoints& from, const std::array<float, 5>& a, const std::array<float, 5>& b) {
    return ((a[3] * b[1]) * from.edge[1] + (a[1] * b[3]) * from.edge[3]) + (a[2] * b[2]) * from.edge[2];
  };
  const Float4 at_corners = (w[4] * corners[0].edge[0] + u[4] * corners[1].edge[0]) + v[4] * corners[2].edge[0];
  const Float4 on_edges = (edge(corners[0], w, u) + edge(corners[1], u, v)) + edge(corners[2], v, w);
  const Float4 inside = ((w[2] * (u[1] * v[1])) * corners[0].inner + (u[2] * (v[1] * w[1])) * corners[1].inner) +
                        (v[2] * (w[1] * u[1])) * corners[2].inner;
  return (at_corners + on_edges) + inside;
}

// The place of a corner's point in the patches of the mesh after one split.
struct PatchPoint {
  std::size_t patch, point;
};
inline std::array<PatchPoint, 5> quartic_points(std::size_t triangle, std::size_t corner) {
  const std::size_t first = 4 * triangle, next = (corner + 1) % 3;
  // Child i has corner i. Its edges i and i + 2 lie on edges of the triangle; edge i + 1 lies inside.
  return {{{first + corner, corner},
           {first + corner, 3 + corner},
           {first + corner, next},
           {first + next, 3 + corner},
           {first + corner, 3 + next}}};
}

}  // namespace glark::qas
