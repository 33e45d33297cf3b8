// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a simplified mesh keeps of the original: the surface, its borders, and its edges by position.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::bench {

struct MeshView {
  std::span<const float> positions;
  std::span<const std::uint32_t> triangles;
};

// Distances both ways, the greater of the two, in % of the original's diagonal.
struct MeshDistances {
  double rms = 0, greatest = 0;
  double borders = 0;  // the greatest distance between borders; 0 without borders
};
MeshDistances distances_between(const MeshView& original, const MeshView& result, std::size_t samples);

// Vertices at one position count as one vertex.
std::vector<std::uint32_t> welded(const MeshView& mesh);
// The number of edges with more than two triangles, by position.
std::size_t non_manifold_by_position(const MeshView& mesh);

}  // namespace glark::bench
