// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Drawings of patterns, from the pieces that the library uploads to the GPU.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glark/core/pattern/expand.h"

namespace glark::tool {

// The role of a triangle. Skirts and fans touch an edge of the coarse triangle, the interior does not.
enum class Part { interior, skirt, fan };

// Barycentrics of corners 1 and 2 of the coarse triangle.
struct PatternPoint {
  double u, v;
};

struct PatternTriangle {
  std::array<PatternPoint, 3> corners;  // counter-clockwise
  Part part;
};

// The triangles of the pattern with 2^depths[i] segments on edge i. Edge 0 joins corners 0 and 1, edge 1 corners 1 and
// 2, edge 2 corners 2 and 0. Throws std::invalid_argument for a depth outside 0..11.
std::vector<PatternTriangle> pattern_triangles(std::array<int, 3> depths, pattern::Interior interior);

// The same as an SVG picture. Corner 0 is on the left, corner 1 on the right, corner 2 at the top. Every edge has its
// depth and its number of segments beside it.
std::string pattern_as_svg(std::array<int, 3> depths, pattern::Interior interior);

}  // namespace glark::tool
