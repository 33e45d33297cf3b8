// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A triangle between Begin and End, and the number of its refined triangles.
#pragma once

#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {

// draw() draws one triangle in immediate mode, and is captured.
inline std::size_t triangles_of(Test& t, const std::function<void()>& draw) {
  const std::size_t triangles = capture(t, draw).size() / 3;
  t.expect_equal(std::size_t{count_generated(draw)}, triangles, "triangles without transform feedback");
  return triangles;
}

inline void draw_immediate_triangle() {
  gl.Begin(GL_TRIANGLES);
  gl.VertexAttrib4f(0, -0.5F, -0.5F, 0, 1);
  gl.VertexAttrib4f(0, 0.5F, -0.5F, 0, 1);
  gl.VertexAttrib4f(0, 0, 0.5F, 0, 1);
  gl.End();
}

inline void refine_immediate_triangles(Test& t, GLuint level = 4) {
  gl.UseProgram(capture_program(t));
  gl.ARKinit(level);
  gl.Enable(GL_ARK);
}

}  // namespace glark::conformance
