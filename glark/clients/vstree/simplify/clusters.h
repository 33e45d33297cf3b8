// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clusters of samples. One point represents each cluster in the result.
#pragma once

#include <glark/vstree.h>

#include <optional>

#include "glark/clients/common/points/point_set.h"
#include "glark/clients/common/workers.h"
#include "glark/clients/vstree/quadric.h"

namespace glark::vstree {

// The input of a simplification, after its validation.
struct Surface {
  Cube cube;
  PointSet points;  // with normals
  std::span<const std::uint32_t> triangles;

  std::size_t size() const { return points.positions.size() / 3; }
  Float4 point(std::size_t i) const { return cube.inside(&points.positions[3 * i]); }  // in the unit cube
};

// An edge with one triangle, where points at one position count as one.
struct BoundaryEdge {
  std::uint32_t from, to, opposite;  // points; the last is the third corner of the triangle
};

struct Clusters {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of;         // [points]
  std::vector<std::uint32_t> triangles;  // clusters as vertices, without repeats; empty: not known yet
  std::vector<std::uint8_t> irregular;   // [count] the result of irregular_vertices() for these triangles with repeats
  std::optional<std::vector<BoundaryEdge>> boundary;  // of the surface, at that of these triangles; null: not known yet

  void set_triangles(std::vector<std::uint32_t> spanning);
};

Clusters cluster(const Surface& surface, const SimplifyOptions& options, const Workers& workers);

}  // namespace glark::vstree
