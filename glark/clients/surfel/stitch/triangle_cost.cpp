// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/stitch/triangle_cost.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/surfel/stitch/hole_filling.h"

namespace glark::surfel {
namespace {

float square(float x) { return x * x; }

}  // namespace

Vector point_normal(const Level& level, std::uint32_t point) {
  const Surfel& surfel = level.surfel(point);
  return surfel.normal == Vector{} ? level.tree.leaves[level.owner[point]].normal : surfel.normal;
}

float triangle_cost(const Level& level, const Triangle& triangle) {
  const Vector a = level.positions[triangle[0]], b = level.positions[triangle[1]];
  const Vector c = level.positions[triangle[2]];
  const Vector facet_normal = cross(b - a, c - a);
  const float squared_size = dot(facet_normal, facet_normal);
  if (!(squared_size > 0)) return infinite_cost;
  Vector sum;
  for (const std::uint32_t corner : triangle) sum = sum + level.surfel(corner).normal;
  const Vector normal = unit(sum);
  constexpr float least_cosine = 0.1F;
  const float cosine = normal == Vector{} ? 1 : dot(unit(facet_normal), normal);
  const float squared_radius = dot(b - a, b - a) * dot(c - b, c - b) / squared_size * dot(a - c, a - c);
  return squared_radius / square(std::max(std::fabs(cosine), least_cosine)) * (cosine < 0 ? -1.0F : 1.0F);
}

}  // namespace glark::surfel
