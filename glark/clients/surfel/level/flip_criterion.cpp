// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/level/flip_criterion.h"

#include <algorithm>
#include <limits>

namespace glark::surfel {
namespace {

// The limit for the sum of the cotangents of the two angles opposite to the new edge. Delaunay edges have sums of at
// least 0. This limit is the sum for two angles of 130 degrees.
constexpr float least_cotangents = -1.68F;

}  // namespace

bool may_flip_edge(Vector p, Vector a, Vector d, Vector b) {
  const Vector pa = a - p, pb = b - p, pd = d - p, da = a - d, db = b - d;
  const Vector at_a = cross(pa, pd), at_b = cross(pd, pb);
  const float size_a = length(at_a), size_b = length(at_b);
  const float smallest = std::numeric_limits<float>::min();
  if (dot(pa, da) / std::max(size_a, smallest) + dot(pb, db) / std::max(size_b, smallest) < least_cotangents)
    return false;
  const Vector at_p = cross(pa, pb), at_d = cross(db, da);
  const float size_p = length(at_p), size_d = length(at_d);
  return dot(at_p, at_d) > least_flat_cosine * size_p * size_d &&
         dot(at_a, at_b) > least_flat_cosine * size_a * size_b &&
         dot(at_p, at_a) > least_flat_cosine * size_p * size_a && dot(at_p, at_b) > least_flat_cosine * size_p * size_b;
}

}  // namespace glark::surfel
