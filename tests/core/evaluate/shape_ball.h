// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A lit octahedron whose vertices have everything that shapes its refinement: depth tags, discontinuities, scalar tags
// and texture coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tests/core/meshes/ball.h"

namespace glark::core::test {

struct ShapeVertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  std::array<GLfloat, 4> discontinuity;
  std::array<GLfloat, 3> scalars;
  std::array<GLfloat, 2> coordinate;
  GLubyte tag;
};

inline std::vector<ShapeVertex> shape_vertices() {
  std::vector<ShapeVertex> vertices;
  for (const auto& p : ball_corners()) {
    ShapeVertex vertex{p, p, {0, 0, 0, 1}, {0, 0, 0}, {0.5F + p[0] / 2, 0.5F + p[1] / 2}, 3};
    if (p[0] > 0 || p[1] > 0) {
      vertex.discontinuity = {0.3F, 0.6F, -0.4F, 1};
      vertex.scalars = {1, 0.2F, 0};
    }
    if (p[1] > 0) vertex.tag = 1;
    vertices.push_back(vertex);
  }
  return vertices;
}

// Where the arrays of the context's attributes lie in the bound buffer.
class ShapeBall {
 public:
  static constexpr GLuint discontinuity_location = 14;
  static constexpr GLuint scalar_location = 13;

  ShapeBall() : vertices_(shape_vertices()), buffer_(make_buffer(GL_ARRAY_BUFFER, vertices_)) {
    constexpr GLsizei stride = sizeof(ShapeVertex);
    glVertexPointer(3, GL_FLOAT, stride, byte_offset(offsetof(ShapeVertex, position)));
    glNormalPointer(GL_FLOAT, stride, byte_offset(offsetof(ShapeVertex, normal)));
    glTexCoordPointer(2, GL_FLOAT, stride, byte_offset(offsetof(ShapeVertex, coordinate)));
    glVertexAttribPointer(discontinuity_location, 4, GL_FLOAT, GL_FALSE, stride,
                          byte_offset(offsetof(ShapeVertex, discontinuity)));
    glVertexAttribPointer(scalar_location, 3, GL_FLOAT, GL_FALSE, stride, byte_offset(offsetof(ShapeVertex, scalars)));
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY}) glEnableClientState(array);
    glEnableVertexAttribArray(discontinuity_location);
    glEnableVertexAttribArray(scalar_location);
    glDepthTagPointerARK(GL_UNSIGNED_BYTE, stride, byte_offset(offsetof(ShapeVertex, tag)));
    for (const GLenum mode : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0}) glEnable(mode);
    glRotatef(25, 1, 0.7F, 0.2F);
  }

  std::vector<ShapeVertex>& vertices() { return vertices_; }
  void write() const {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(vertices_.size() * sizeof(ShapeVertex)),
                    vertices_.data());
  }
  void draw() const { glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size())); }

 private:
  std::vector<ShapeVertex> vertices_;
  GLuint buffer_ = 0;
};

}  // namespace glark::core::test
