// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How GL cuts quads and polygons into triangles. OpenGL 4.6 compatibility, 10.1, leaves this to the implementation.
// glark finds it out: it captures vertices whose attribute is their number.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "glark/gl/types.h"

namespace glark::polygons {

// Maps the vertices of a polygon, numbered along its boundary, to the corners of its triangles.
// Quad: corners[k] of the six corners of its two triangles is vertex k. Fan (GL_POLYGON): in every triangle, corners[0]
// is vertex 0 of the polygon, corners[1] and corners[2] of triangle t are its vertices t + 1 and t + 2.
struct Decomposition {
  bool fan = false;
  std::array<GLint, 4> corners{};
  // The corner at which every triangle of the polygon has its vertex k; -1 if a triangle lacks that vertex, or has it at
  // another corner. Fan: only for vertex 0.
  std::array<int, 4> common_corners{-1, -1, -1, -1};
};

// Cuts captured quads again. Both new triangles end with vertex `about` of the boundary.
struct Cut {
  Decomposition captured;
  int about = 3;
};

// The edge that divides a quad, by the numbers of its vertices along the boundary.
enum class Diagonal { from_first, from_second };
// Returns the diagonal of a quad that is decomposed so.
constexpr Diagonal diagonal_of(const Decomposition& quad) {
  // The first triangle lacks one vertex. The diagonal does not pass through that vertex.
  return quad.corners[0] > 2 || quad.corners[2] > 2 ? Diagonal::from_second : Diagonal::from_first;
}

// The provoking vertex of a polygon, by its number along the boundary. `first`: of a quad under
// GL_FIRST_VERTEX_CONVENTION, if quads follow it. OpenGL 4.6 compatibility, table 13.2.
constexpr int provoking_vertex(GLenum mode, bool first) {
  return mode == GL_POLYGON || first ? 0 : mode == GL_QUAD_STRIP ? 2 : 3;
}

inline bool is_polygon_mode(GLenum mode) { return mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON; }

// The number of vertices of the probe, a draw that shows the decomposition of `mode`: two quads, or a pentagon.
constexpr GLsizei probe_vertices(GLenum mode) { return mode == GL_QUADS ? 8 : mode == GL_QUAD_STRIP ? 6 : 5; }

// `numbers`: the numbers (0, 1, ...) of the probe's vertices in the order in which transform feedback captured them.
// Empty unless GL cuts all quads along a diagonal in the same way, and a polygon into a fan about its first vertex.
std::optional<Decomposition> decomposition_of(GLenum mode, std::span<const float> numbers);

}  // namespace glark::polygons
