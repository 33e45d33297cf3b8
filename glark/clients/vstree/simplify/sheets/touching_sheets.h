// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sheets that an edge collapse brings together.
#pragma once

#include <utility>
#include <vector>

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// The two ends of an edge, the smaller vertex first.
using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Returns the edges of more than two triangles, sorted. count: the number of vertices.
std::vector<Edge> crowded_edges(const std::vector<std::uint32_t>& triangles, std::size_t count);

// The number of such edges, where vertices at one position count as one.
std::size_t crowded_edge_count(std::span<const float> positions, std::span<const std::uint32_t> triangles);

// Makes at most two triangles meet in an edge, where vertices at one position count as one. Removes pairs of triangles
// that cover each other. Moves the vertices of touching sheets a little apart, each by at most `most_moved` times the
// diagonal of the surface's bounding box. Edges between points where the surface itself has more than two triangles at an edge stay as they are.
void part_touching_sheets(const Surface& surface, float most_moved, Simplified& result);

}  // namespace glark::vstree
