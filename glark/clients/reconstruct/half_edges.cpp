// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/half_edges.h"

#include <glark/vstree.h>

#include <numeric>

namespace glark::vstree {

std::vector<std::uint32_t> opposite_of(const std::vector<std::uint32_t>& triangles, std::size_t vertices) {
  std::vector<std::uint32_t> begins(vertices + 2), from(triangles.size()), opposite(triangles.size(), none);
  for (const std::uint32_t i : triangles) ++begins[i + 2];
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) from[begins[triangles[i] + 1]++] = i;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t start = triangles[i], end = triangles[next_corner(i)];
    for (std::uint32_t k = begins[end]; k < begins[end + 1]; ++k) {
      if (triangles[next_corner(from[k])] == start) opposite[i] = from[k];
    }
  }
  return opposite;
}

}  // namespace glark::vstree
