// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/triangle_normals.h"

#include <span>

#include "glark/clients/common/vertex_normals.h"

namespace glark::geometry {

std::vector<float> triangle_normals(const Geometry& mesh) {
  const auto position = [&](std::uint32_t point) {
    const auto at = common::vector_at(std::span<const float>(mesh.positions), point);
    return common::Vector3d{at.x, at.y, at.z};
  };
  std::vector<common::Vector3d> sums(mesh.point_count());
  common::add_triangle_normals(mesh.triangles, position,
                               [&](std::uint32_t point, common::Vector3d normal) { sums[point] += normal; });
  std::vector<float> result;
  result.reserve(mesh.positions.size());
  for (const common::Vector3d& sum : sums) {
    const common::Vector3d normal = common::unit(sum);
    for (std::size_t axis = 0; axis < 3; ++axis) result.push_back(static_cast<float>(normal[axis]));
  }
  return result;
}

}  // namespace glark::geometry
