// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The coarse mesh, with one vertex at each position and unit normals.
#pragma once

#include <glark/maps.h>

#include <array>
#include <cstdint>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::maps {

using Vector = common::Vector3f;

inline constexpr std::uint32_t none = 0xFFFFFFFF;

struct Surface {
  std::vector<Vector> positions, normals;                 // of the vertices
  std::vector<std::array<std::uint32_t, 3>> triangles;    // vertices
  std::vector<Vector> triangle_normals;                   // of unit length; zero for a triangle without area
  std::vector<std::array<std::uint32_t, 3>> neighbours;   // across the edges 01, 12 and 20; `none` at a boundary
  std::vector<std::uint32_t> first_of_vertex, of_vertex;  // the triangles at each vertex, one list after the other
  double scale = 1;  // a power of two: positions here are those of the mesh times it, so that the diagonal is about 1
  double diagonal = 0;  // of the bounding box
  double mean_edge = 0;
};

// Errors: as bake(), for the mesh.
Surface surface_of(const CoarseMesh& mesh);

}  // namespace glark::maps
