// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The weights of Loop's scheme that depend on the valence.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace glark::qas {

// The weight of each neighbour of a smooth vertex in one step. Source: C. Loop, Smooth Subdivision Surfaces Based on
// Triangles, 1987.
inline double loop_beta(std::uint32_t valence) {
  const double n = valence;
  const double root = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
  return (5.0 / 8 - root * root) / n;
}

// The weights of an open fan's ring for the two tangents at a crease vertex: along the crease, and across it into the
// fan. At a corner, the tangents are the two edges that bound the fan. The weights multiply differences to the vertex.
//
// The tangents across are left eigenvectors of the step. OpenSubdiv has the formula of Hoppe et al. (1994) for four
// triangles and more. The formula belongs to their modified rules. OpenSubdiv refines by the plain rule for crease
// edges, and with this rule the formula does not give the limit.
struct TangentMask {
  std::uint32_t last;  // the last index of the ring, which is also the number of triangles
  bool corner;
  double theta;
  double end;  // the weight of the first and the last vertex for the tangent across

  double along(std::uint32_t i) const { return i == 0 ? 1 : (i == last && !corner ? -1 : 0); }
  double inwards(std::uint32_t i) const {
    if (corner) return i == last ? 1 : 0;
    return i == 0 || i == last ? end : std::sin(i * theta);
  }
};

inline TangentMask tangent_mask(std::uint32_t ring_size, bool corner) {
  const std::uint32_t last = ring_size - 1;
  const double theta = std::numbers::pi / last;
  if (last == 1) return {last, corner, theta, 1};  // eigenvalue 1/4
  if (last == 2) return {last, corner, theta, 0};  // 3/8
  const double eigenvalue = 3.0 / 8 + std::cos(theta) / 4;
  // The sum of 3/8 sin(i theta): a new inner vertex takes 3/8 of the old vertex.
  const double inner = 3.0 / 8 / std::tan(theta / 2);
  const double end =
      (inner + (eigenvalue - 0.75) * std::sin(theta)) / (8 * (eigenvalue - 0.75) * (eigenvalue - 0.5) - 1);
  return {last, corner, theta, end};
}

}  // namespace glark::qas
