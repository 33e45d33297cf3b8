// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Groups of samples, each of which one point will stand for.
#pragma once

#include <glark/vstree.h>

#include "glark/clients/common/workers.h"
#include "glark/clients/vstree/quadric.h"
#include "glark/clients/common/points/point_set.h"

namespace glark::vstree {

// What is to be simplified, checked.
struct Surface {
  Cube cube;
  PointSet points;  // with normals
  std::span<const std::uint32_t> triangles;

  std::size_t size() const { return points.positions.size() / 3; }
  Float4 point(std::size_t i) const { return cube.inside(&points.positions[3 * i]); }  // in the unit cube
};

struct Clusters {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of;         // [points]
  std::vector<std::uint32_t> triangles;  // over clusters, each once; empty: not known yet
  std::vector<std::uint8_t> irregular;   // [count] as of irregular_vertices(), of these triangles and their repeats

  void set_triangles(std::vector<std::uint32_t> spanning);
};

Clusters cluster(const Surface& surface, const SimplifyOptions& options, const Workers& workers);

}  // namespace glark::vstree
