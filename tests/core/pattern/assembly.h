// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Puts the instances of a pattern together in exact integers, and finds the first defect of the result.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "glark/core/pattern/expand.h"
#include "glark/core/pattern/pool.h"

namespace glark::pattern::testing {

// Barycentrics of the coarse triangle in units of 2^-20.
struct Point {
  std::int64_t u, v;
  bool operator==(const Point&) const = default;
};
inline constexpr std::int64_t whole = 1 << 20;

using Triangle = std::array<Point, 3>;

struct Assembly {
  std::vector<Triangle> triangles;
  bool floats_exact = true;  // the patch formula in float gave these very points, and w + u + v == 1
};

Assembly assemble(const Pool& pool, const std::vector<Instance>& instances);

// Empty if the triangles tile the whole. Every edge i has 2^depths[i] equal segments. Every inner edge lies in exactly
// two triangles, with opposite directions. Every area is positive, and the areas sum to the whole. Otherwise returns
// the first defect.
std::string defect_of(const Assembly& assembly, std::array<int, 3> depths);

// In degrees, measured in the equilateral triangle.
double least_angle(const Assembly& assembly);

}  // namespace glark::pattern::testing
