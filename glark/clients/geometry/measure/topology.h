// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The connectivity of a mesh. Points at the same position are one point, even with different attributes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

struct Topology {
  std::size_t places = 0;                // the number of different positions
  std::size_t unused_points = 0;         // points without triangles; only counted if there are triangles
  std::size_t degenerate_triangles = 0;  // triangles with two corners at one position; the counts below exclude them
  std::size_t boundary_edges = 0;        // edges of one triangle
  std::size_t non_manifold_edges = 0;    // edges of more than two triangles
  std::size_t components = 0;            // triangles that share positions belong to one component
  std::size_t largest_component = 0;     // the number of its triangles
};

Topology topology_of(const Geometry& geometry);

// Two numbers of the topology, in less time.
struct Connections {
  std::size_t components = 0;
  std::size_t non_manifold_edges = 0;
};
Connections connections_of(const Geometry& geometry);

// The number of components alone, in a quarter of that time.
std::size_t component_count(const Geometry& geometry);

// Returns for each point the first one at the same position.
std::vector<std::uint32_t> first_at_same_place(std::span<const float> positions);

// Merges points that agree in all attributes. The remaining points keep their order.
void join_identical_points(Geometry& geometry);

}  // namespace glark::geometry
