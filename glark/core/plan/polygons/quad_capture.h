// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The provoking vertex convention under which quads are captured. It decides along which diagonal GL cuts them. No GL.
#pragma once

#include <optional>

#include "glark/core/capture/draw_call.h"
#include "glark/core/polygons/drawn_diagonals.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/capabilities.h"

namespace glark::core {

// OpenGL 4.6 compatibility, 13.4: under GL_FIRST_VERTEX_CONVENTION, the provoking vertex of quads may still be their
// last one. Such draws are captured under the last vertex convention, where the triangles of a quad end with its
// provoking vertex.
bool captures_last_vertex(const Bindings& bindings, const Capabilities& capabilities, GLenum mode);

// Returns whether a quad should be captured as it is drawn. The diagonal does not matter if the vertices of a quad are
// split at its centre. A flat output needs its provoking vertex in both triangles. A curved mesh must have the same
// triangles in all passes, whichever way each of them is drawn.
struct QuadFacts {
  GLenum mode = GL_QUADS;
  GLenum polygon_mode = GL_FILL;
  GLenum shade_model = GL_SMOOTH;
  bool writes_flat_outputs = false;
  bool moves_vertices = false;  // off the coarse triangles
  bool split = false;           // at the centroid
};
bool follows_drawn_diagonal(const QuadFacts& facts);

polygons::QuadSource quad_source(const DrawCall& call);

inline GLenum other_convention(GLenum convention) {
  return convention == GL_LAST_VERTEX_CONVENTION ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION;
}

}  // namespace glark::core
