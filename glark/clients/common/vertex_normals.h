// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals at the vertices of a triangle mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "glark/clients/common/float4.h"
#include "glark/clients/common/vector.h"

namespace glark::common {

// Adds the normal of each triangle to its three vertices. The length of the normal is twice the area of the triangle.
// So the sums, scaled to unit length, are means weighted by area.
// position(vertex) returns a vector; add(vertex, normal) takes one.
template <class Position, class Add>
void add_triangle_normals(std::span<const std::uint32_t> triangles, const Position& position, const Add& add) {
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const auto a = position(triangles[t]);
    const auto normal = cross(position(triangles[t + 1]) - a, position(triangles[t + 2]) - a);
    for (std::size_t k = 0; k < 3; ++k) add(triangles[t + k], normal);
  }
}

}  // namespace glark::common
