// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The edges of a mesh whose vertices at one position count as one vertex. Other programs see a mesh in this way, because
// many formats keep no indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::reconstruct {

struct EdgeCounts {
  std::size_t boundary = 0;      // edges of one triangle
  double boundary_length = 0;    // the sum of their lengths
  std::size_t non_manifold = 0;  // edges of more than two triangles
};

// Triangles with two corners at one position do not count.
EdgeCounts count_edges(std::span<const float> positions, std::span<const std::uint32_t> triangles);

// Where an edge has more than two triangles by its indices, gives each sheet its own vertices. Returns for each vertex
// its original; the first ones are their own originals, and copies follow.
std::vector<std::uint32_t> cut_at_edges(std::span<const float> positions, std::vector<std::uint32_t>& triangles);

// Moves vertices at one position apart where an edge has more than two triangles, until each edge has at most two. By
// its indices, the mesh must be a manifold. A vertex moves by about a fiftieth of the size of its triangles, towards
// their middle. If that does not help, the vertices at one position also move along their normals, by different ways.
// positions, normals: [3 * vertices].
void part_places(std::span<float> positions, std::span<const float> normals, std::span<const std::uint32_t> triangles);

}  // namespace glark::reconstruct
