// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The order of the triangles of a regular pattern, for the post-transform vertex cache.
#pragma once

#include <array>
#include <vector>

namespace glark::pattern {

// A point of the regular lattice with n segments on every edge: u = i / n, v = j / n.
struct LatticePoint {
  int i, j;
};
using LatticeTriangle = std::array<LatticePoint, 3>;

struct UniformOrder {
  std::vector<LatticeTriangle> triangles;  // n^2
  std::size_t interior_count;              // the first triangles do not touch the border: (n - 3)^2, or 0 if n < 4
};

UniformOrder order_uniform(int n);

}  // namespace glark::pattern
