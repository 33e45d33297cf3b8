// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/area.h"

#include "glark/clients/geometry/measure/nearest_on_triangle.h"

namespace glark::geometry {

double area_of(const Geometry& mesh) {
  const auto corner = [&](std::size_t i) {
    const float* const position = &mesh.positions[3 * std::size_t{mesh.triangles[i]}];
    return Vector{position[0], position[1], position[2]};
  };
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) sum += area_of({corner(i), corner(i + 1), corner(i + 2)});
  return sum;
}

}  // namespace glark::geometry
