// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program with a camera, and a context that refines by measured depths.
#pragma once

#include <cmath>

#include "tests/core/support/curved_program.h"

namespace glark::core::test {

using Matrix = std::array<GLfloat, 16>;  // by columns

// A view of 90 degrees, from `distance` in front of the origin, turned about y by `turn`.
inline Matrix perspective(GLfloat distance, GLfloat turn = 0) {
  const GLfloat c = std::cos(turn);
  const GLfloat s = std::sin(turn);
  return {c, 0, s, s, 0, 1, 0, 0, s, 0, -c, -c, 0, 0, distance - 0.2F, distance};
}

inline constexpr Matrix flat_view{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

// The attributes are those of link_curved_program().
inline GLuint link_measured_program() {
  return link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                 "uniform mat4 view; uniform float bend; out vec3 passed_weights; out float passed_triangle;\n"
                 "void main() { gl_Position = view * vec4(position + bend * normal, 1.0);\n"
                 "  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nin vec3 passed_weights; out vec4 color;\n"
                   "void main() { color = vec4(passed_weights, 1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle"}});
}

inline void set_view(GLuint program, const Matrix& view) {
  glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view.data());
}

inline void measure_depths(GLuint level, GLint pixels, GLint degrees = 0, GLint budget = 0) {
  glARKinit(level);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, pixels);
  glARKParameteriARK(GL_EDGE_DEGREES_ARK, degrees);
  glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);
  glEnable(GL_ARK);
}

}  // namespace glark::core::test
