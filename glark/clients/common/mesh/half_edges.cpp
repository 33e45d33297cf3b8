// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/mesh/half_edges.h"

#include <numeric>

namespace glark::common {

std::vector<std::uint32_t> opposite_of(const std::vector<std::uint32_t>& triangles, std::size_t vertices) {
  struct HalfEdge {
    std::uint32_t end, corner;
  };
  std::vector<std::uint32_t> begins(vertices + 2), opposite(triangles.size(), no_half_edge);
  std::vector<HalfEdge> from(triangles.size());  // sorted by the start of the half-edges
  for (const std::uint32_t i : triangles) ++begins[i + 2];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  for (std::uint32_t t = 0; t < triangles.size(); t += 3) {
    for (std::uint32_t i = 0; i < 3; ++i) from[begins[triangles[t + i] + 1]++] = {triangles[t + (i + 1) % 3], t + i};
  }
  for (std::uint32_t start = 0; start < vertices; ++start) {
    for (std::uint32_t i = begins[start]; i < begins[start + 1]; ++i) {
      const HalfEdge edge = from[i];
      if (edge.end < start) continue;
      for (std::uint32_t k = begins[edge.end]; k < begins[edge.end + 1]; ++k) {
        if (from[k].end != start) continue;
        opposite[edge.corner] = from[k].corner;
        opposite[from[k].corner] = edge.corner;
      }
    }
  }
  return opposite;
}

}  // namespace glark::common
