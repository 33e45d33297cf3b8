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

using Point2 = std::array<float, 2>;

struct Surface {
  std::vector<Vector> positions, normals;                 // of the vertices
  std::vector<std::array<std::uint32_t, 3>> triangles;    // vertices
  std::vector<Vector> triangle_normals;                   // of unit length; zero for a triangle without area
  std::vector<std::array<std::uint32_t, 3>> neighbours;   // across the edges 01, 12 and 20; `none` at a boundary
  std::vector<std::array<bool, 3>> hard;                  // the edges where the fine surface has a crease; or empty
  std::vector<std::uint32_t> first_of_vertex, of_vertex;  // the triangles at each vertex, one list after the other
  std::vector<std::array<Point2, 3>> texcoords;       // of the triangles' corners, t = 0 is the lower edge; or empty
  std::vector<std::uint32_t> welded;                  // the vertex that each vertex of the mesh became
  std::vector<std::array<std::uint32_t, 3>> sources;  // the vertices of the mesh at the triangles' corners
  double scale = 1;  // a power of two: positions here are those of the mesh times it, so that the diagonal is about 1
  double diagonal = 0;  // of the bounding box
  double mean_edge = 0;
};

// Errors: as bake(), for the mesh.
Surface surface_of(const CoarseMesh& mesh);

// Whether the normals of the fine surface jump at an edge.
inline bool is_hard(const Surface& surface, std::uint32_t triangle, std::size_t edge) {
  return !surface.hard.empty() && surface.hard[triangle][edge];
}

// Returns the corner of a triangle, 0, 1 or 2, at one of its vertices.
std::size_t corner_at(const Surface& surface, std::uint32_t triangle, std::uint32_t vertex);

}  // namespace glark::maps
