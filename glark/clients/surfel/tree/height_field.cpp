// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/height_field.h"

#include <algorithm>
#include <cmath>

namespace glark::surfel {

Shape classify_shape(std::span<const Surfel> surfels, const Plane& plane, const HeightFieldLimits& limits) {
  float radius = 0;
  float height = 0;
  bool folded = false;
  for (const Surfel& surfel : surfels) {
    const Vector d = surfel.position - plane.centre;
    radius = std::max(radius, dot(d, d));
    height = std::max(height, std::fabs(dot(d, plane.normal)));
    folded = folded || (!(surfel.normal == Vector{}) && dot(surfel.normal, plane.normal) < limits.delta_a);
  }
  if (folded) return Shape::folded;
  return height > limits.delta_d * std::sqrt(radius) ? Shape::thick : Shape::height_field;
}

std::size_t split_by_normals(std::span<Surfel> surfels, const Plane& plane) {
  const auto farthest_from = [&](Vector normal) {
    Vector farthest = normal;
    float cosine = 2;
    for (const Surfel& surfel : surfels) {
      if (surfel.normal == Vector{} || !(dot(surfel.normal, normal) < cosine)) continue;
      cosine = dot(surfel.normal, normal);
      farthest = surfel.normal;
    }
    return farthest;
  };
  const Vector first = farthest_from(plane.normal);
  const Vector second = farthest_from(first);
  const Vector between = first - second;
  const auto end_of_first = std::stable_partition(
      surfels.begin(), surfels.end(), [&](const Surfel& surfel) { return dot(surfel.normal, between) > 0; });
  return static_cast<std::size_t>(end_of_first - surfels.begin());
}

}  // namespace glark::surfel
