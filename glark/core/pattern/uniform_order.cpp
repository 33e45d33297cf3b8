// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/uniform_order.h"

#include <algorithm>

namespace glark::pattern {
namespace {

// Cells across a band. The vertices of two rows of a band, 2 * (7 + 1), fit in a first-in-first-out cache of 16
// entries.
constexpr int band_width = 7;

LatticeTriangle upward(int i, int j) { return {LatticePoint{i, j}, {i + 1, j}, {i, j + 1}}; }
LatticeTriangle downward(int i, int j) { return {LatticePoint{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}; }

// All triangles with i, j >= low and i + j <= high, band after band, each row after row.
void append_bands(int low, int high, std::vector<LatticeTriangle>& triangles) {
  for (int left = low; left + low < high; left += band_width) {
    for (int j = low; left + j < high; ++j) {
      int right = std::min(left + band_width, high - j);
      for (int i = left; i < right; ++i) {
        triangles.push_back(upward(i, j));
        if (i + j + 2 <= high) triangles.push_back(downward(i, j));
      }
    }
  }
}

// Corner k of the lattice goes to corner k + 1.
LatticePoint rotate_once(LatticePoint p, int n) { return {n - p.i - p.j, p.i}; }

LatticeTriangle rotate(LatticeTriangle triangle, int n, int times) {
  for (LatticePoint& p : triangle) {
    for (int k = 0; k < times; ++k) p = rotate_once(p, n);
  }
  return triangle;
}

// The triangles that touch the border: three strips, each without the two triangles that begin the next.
void append_ring(int n, std::vector<LatticeTriangle>& triangles) {
  for (int edge = 0; edge < 3; ++edge) {
    for (int i = 0; i < n - 1; ++i) {
      triangles.push_back(rotate(upward(i, 0), n, edge));
      if (i < n - 2) triangles.push_back(rotate(downward(i, 0), n, edge));
    }
  }
}

}  // namespace

UniformOrder order_uniform(int n) {
  UniformOrder order{};
  order.triangles.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  if (n < 4) {
    append_bands(0, n, order.triangles);
    return order;
  }
  append_bands(1, n - 1, order.triangles);
  order.interior_count = order.triangles.size();
  append_ring(n, order.triangles);
  return order;
}

}  // namespace glark::pattern
