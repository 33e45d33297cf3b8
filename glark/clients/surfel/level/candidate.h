// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Triangles over a level's points, and the triangles that a leaf proposes to draw.
#pragma once

#include <array>
#include <cstdint>

namespace glark::surfel {

using Triangle = std::array<std::uint32_t, 3>;  // indices of points, counter-clockwise
using Corners = std::array<std::uint32_t, 3>;   // indices of a triangle's points, ascending

// The first two corners as one number.
inline std::uint64_t first_two(const Corners& corners) { return std::uint64_t{corners[0]} << 32 | corners[1]; }

// Lexicographic order.
inline bool is_before(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  return first_two(a) < first_two(b) || (first_two(a) == first_two(b) && a[2] < b[2]);
}

enum class CandidateState : std::uint8_t {
  conflicting,   // the leaves that own the corners do not all have the triangle
  agreed,        // all leaves that own a corner have the triangle
  back_facing,   // the normals of the corners point to the other side
  out_of_reach,  // an edge is too long
  boundary,      // not a triangle but a boundary edge; the last corner is repeated
};

// A triangle of a leaf's triangulation with at least one of the leaf's points. It may be drawn.
struct Candidate {
  Corners corners;
  bool reversed;     // the corners are in clockwise order
  bool back_facing;  // the normals of the corners point to the other side
  CandidateState state;
};

inline Triangle triangle_of(const Candidate& candidate) {
  const auto [a, b, c] = candidate.corners;
  return candidate.reversed ? Triangle{a, c, b} : Triangle{a, b, c};
}

}  // namespace glark::surfel
