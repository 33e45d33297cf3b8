// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program with a position and a normal, whose outputs tell where its refined vertices are.
#pragma once

#include "tests/core/support/refined_capture.h"

namespace glark::core::test {

enum class Language { glsl_120, glsl_450_core };

// Attributes: 0 position, 1 normal, 2 weights, 3 triangle. The matrix has no round numbers.
inline GLuint link_curved_program(Language language) {
  const std::string body =
      "const mat4 view = mat4(0.31, 0.17, -0.2, 0.03, -0.11, 0.37, 0.07, 0.01, 0.13, 0.05, 0.41, -0.07, 0.02, -0.03, "
      "0.09, 1.3);\n"
      "void main() {\n"
      "  vec3 bent = position + 0.07 * normal * (1.0 + dot(position, normal));\n"
      "  gl_Position = view * vec4(bent, 1.0);\n"
      "  passed_weights = weights;\n"
      "  passed_triangle = triangle;\n"
      "}\n";
  const std::string old_head =
      "#version 120\nattribute vec3 position; attribute vec3 normal; attribute vec3 weights; attribute float "
      "triangle;\n"
      "varying vec3 passed_weights; varying float passed_triangle;\n";
  const std::string new_head =
      "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
      "out vec3 passed_weights; out float passed_triangle;\n";
  const bool core = language == Language::glsl_450_core;
  return link_program(
      {.vertex = (core ? new_head : old_head) + body,
       .fragment = core ? "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n" : "",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle"}});
}

struct CurvedVertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  std::array<GLfloat, 3> weights;
  GLfloat triangle;
  GLubyte tag;
};

// Points attributes 0 to 3 and the depth tags into a new buffer.
inline void upload(const std::vector<CurvedVertex>& vertices) {
  make_buffer(GL_ARRAY_BUFFER, vertices);
  constexpr GLsizei stride = sizeof(CurvedVertex);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(CurvedVertex, position)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(CurvedVertex, normal)));
  glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(CurvedVertex, weights)));
  glVertexAttribPointer(3, 1, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(CurvedVertex, triangle)));
  for (GLuint i = 0; i < 4; ++i) glEnableVertexAttribArray(i);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, stride, byte_offset(offsetof(CurvedVertex, tag)));
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

}  // namespace glark::core::test
