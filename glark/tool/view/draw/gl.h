// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The OpenGL functions of the viewer, from GLFW, EGL or OSMesa, whichever made the context. glad generates the loader.
#pragma once

#include <glad/gl.h>

#include <cstddef>

namespace glark::tool {

extern GladGLContext gl;

// Loads the functions of the current context. Throws std::runtime_error if the context is below OpenGL 3.0.
void load_gl(GLADloadfunc loader);

// Builds the pool of patterns, unless it has this level. A new pool forgets what the frame's budget has counted.
void need_patterns(int level);

// Returns how many triangles OpenGL makes of a draw, refined ones included.
template <class Draw>
std::size_t triangles_made_by(Draw&& draw) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
  draw();
  gl.EndQuery(GL_PRIMITIVES_GENERATED);
  GLuint triangles = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &triangles);
  gl.DeleteQueries(1, &query);
  return triangles;
}

}  // namespace glark::tool
