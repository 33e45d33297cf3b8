// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depth tags, edge depths and patterns (10.R.1, 11.R.4, 11.R.5, 11.R.6) as in the text, in exact arithmetic.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glark::conformance::reference {

using Depths = std::array<int, 3>;  // of edges 0, 1 and 2

// Barycentric coordinates in units of 2^-30: exact for every weight of a pattern in single precision.
struct Weights {
  std::int64_t w = 0;
  std::int64_t u = 0;
  std::int64_t v = 0;
  auto operator<=>(const Weights&) const = default;
};
inline constexpr std::int64_t unit = std::int64_t{1} << 30;

// The depth tag of a vertex whose attribute has this first component.
int depth_tag(float value, int pool_level);
// The depth of the edge between vertices with these depth tags.
int edge_depth(int a, int b);
Depths edge_depths(const std::array<int, 3>& tags);

// Corners 0, 1 and 2, as weights.
std::array<Weights, 3> corners();
// From corner `edge` to the next, both corners included.
std::vector<Weights> edge_vertices(int edge, int depth);
// The inner vertices of a pattern with three equal depths.
std::vector<Weights> inside_vertices(int depth);
// All vertices of the pattern with MINIMUM_INTERIOR_ARK, sorted.
std::vector<Weights> minimum_vertices(const Depths& depths);
std::int64_t minimum_triangles(const Depths& depths);

// Returns nothing if a weight is not between 0 and 1 or is finer than the unit, or if the sum is not 1.
std::optional<Weights> exact_weights(float w, float u, float v);

// Checks the rules of 11.R.5 for all patterns. Returns an empty text, or what is wrong. `triangles` has three corners
// for each refined triangle.
std::string fault_of_pattern(const std::vector<Weights>& triangles, const Depths& depths);
// Also checks the rules of 11.R.5 for MINIMUM_INTERIOR_ARK.
std::string fault_of_minimum(const std::vector<Weights>& triangles, const Depths& depths);
// The depths of edges 0, 1 and 2, from the segments along them; -1 if their number is no power of two.
Depths depths_found(const std::vector<Weights>& triangles);

// (11.R.1), with every operation rounded separately.
float refined(float a0, float a1, float a2, const Weights& weights);

}  // namespace glark::conformance::reference
