// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The connectivity of a mesh. Points at the same place count as one, whatever their attributes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

struct Topology {
  std::size_t places = 0;                // the number of different positions
  std::size_t unused_points = 0;         // without triangles; only counted if there are triangles
  std::size_t degenerate_triangles = 0;  // with two corners at one place; not counted below
  std::size_t boundary_edges = 0;        // of one triangle
  std::size_t non_manifold_edges = 0;    // of more than two
  std::size_t components = 0;            // of triangles that share places
  std::size_t largest_component = 0;     // its triangles
};

Topology topology_of(const Geometry& geometry);

// For each point the first one with the same position.
std::vector<std::uint32_t> first_at_same_place(std::span<const float> positions);

// Merges points that agree in all attributes. The others keep their order.
void join_identical_points(Geometry& geometry);

}  // namespace glark::geometry
