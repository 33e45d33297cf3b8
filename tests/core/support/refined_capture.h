// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Refined triangles, read back through the application's own transform feedback (11.R "Post-Processing").
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "tests/core/support/programs.h"

namespace glark::core::test {

struct RefinedVertex {
  std::array<GLfloat, 4> position;  // gl_Position
  std::array<GLfloat, 3> weights;   // barycentric, as an attribute that is 1 at its own corner
  GLfloat triangle;                 // of the coarse mesh, as an attribute
};

// Returns the vertices that draw() gives to transform feedback, three for each triangle.
template <typename Draw>
std::vector<RefinedVertex> capture_refined(std::size_t most_triangles, Draw&& draw) {
  GLuint buffer = 0;
  GLuint query = 0;
  GLuint written = 0;
  glGenBuffers(1, &buffer);
  glGenQueries(1, &query);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  const auto bytes = static_cast<GLsizeiptr>(most_triangles * 3 * sizeof(RefinedVertex));
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
  glBeginTransformFeedback(GL_TRIANGLES);
  draw();
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &written);
  EXPECT_LT(written, most_triangles) << "the buffer of the test is too small";
  std::vector<RefinedVertex> vertices(std::size_t{written} * 3);
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(vertices.size() * sizeof(RefinedVertex)),
                     vertices.data());
  glDeleteBuffers(1, &buffer);
  glDeleteQueries(1, &query);
  return vertices;
}

using PositionBits = std::array<std::uint32_t, 4>;

// Equal bits, except for the sign of zero (11.R.8).
inline PositionBits bits_of(const RefinedVertex& vertex) {
  PositionBits bits;
  for (std::size_t i = 0; i < 4; ++i) {
    const GLfloat value = vertex.position[i] + 0.0F;
    std::memcpy(&bits[i], &value, sizeof(value));
  }
  return bits;
}

}  // namespace glark::core::test
