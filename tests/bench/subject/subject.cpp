// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/subject/subject.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace glark::bench {
namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

template <typename T>
void fill(GLenum target, GLuint buffer, const std::vector<T>& values) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

void generic_array(GLuint input, GLint size, std::size_t at) {
  glEnableVertexAttribArray(input);
  glVertexAttribPointer(input, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), offset(at));
}

}  // namespace

Subject::Subject(const Mesh& mesh, Shading shading, View view, const std::vector<std::uint8_t>& tags)
    : shading_(shading),
      view_(view),
      index_count_(static_cast<GLsizei>(mesh.indices.size())),
      vertex_count_(static_cast<GLsizei>(mesh.vertices.size())),
      first_vertex_(mesh.vertices.front()) {
  glGenVertexArrays(1, &array_);
  glBindVertexArray(array_);
  glGenBuffers(3, buffers_);
  fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[1], mesh.indices);
  if (!tags.empty()) {
    fill(GL_ARRAY_BUFFER, buffers_[2], tags);
    glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
    glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  }
  fill(GL_ARRAY_BUFFER, buffers_[0], mesh.vertices);
  set_pointers();
}

Subject::~Subject() {
  glDeleteVertexArrays(1, &array_);
  glDeleteBuffers(3, buffers_);
}

void Subject::set_pointers() const {
  if (shading_ == Shading::glsl) {
    generic_array(position_input, 3, offsetof(Vertex, position));
    generic_array(normal_input, 3, offsetof(Vertex, normal));
    generic_array(uv_input, 2, offsetof(Vertex, uv));
    return;
  }
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, position)));
  glEnableClientState(GL_NORMAL_ARRAY);
  glNormalPointer(GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, normal)));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, uv)));
}

void Subject::bind(bool refined) const {
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  if (refined) {
    glEnable(GL_ARK);
  } else {
    glDisable(GL_ARK);
  }
}

void Subject::draw() const {
  if (index_count_ == 0) {
    glDrawArrays(GL_TRIANGLES, 0, vertex_count_);
  } else {
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
  }
}

Competitor Subject::as_is() const {
  return {[this] {
            use_shading(shading_, view_);
            bind(false);
          },
          [this] { draw(); }};
}

Competitor Subject::refined(unsigned level) const {
  return {[this, level] {
            use_shading(shading_, view_);
            glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
            glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, static_cast<GLint>(level));
            bind(true);
          },
          [this] { draw(); }};
}

Competitor Subject::tagged() const {
  return {[this] {
            use_shading(shading_, view_);
            glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
            bind(true);
          },
          [this] { draw(); }};
}

Competitor Subject::measured(float pixels) const {
  return {[this, pixels] {
            use_shading(shading_, view_);
            glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
            glARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
            glARKParameterfARK(GL_SCREEN_ERROR_ARK, pixels);
            bind(true);
          },
          [this] { draw(); }};
}

void Subject::draw_by_array() const {
  glBindVertexArray(array_);
  draw();
}

void Subject::draw_by_pointers() const {
  glBindVertexArray(0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  set_pointers();
  draw();
}

// Draws in pieces of less than 2^16 vertices, because llvmpipe 22.3 draws wrong triangles in larger pieces.
Competitor Subject::tessellated(unsigned level) const {
  const GLsizei segments = 1 << level;
  const GLsizei vertices_of_patch = segments * segments + 2 * segments + 4;  // the most vertices of a patch
  const GLsizei most_indices = 3 * std::max(1, 65000 / vertices_of_patch);
  return {[this, level] {
            use_tessellation(view_, level);
            bind(false);
          },
          [this, most_indices] {
            for (GLsizei first = 0; first < index_count_; first += most_indices) {
              glDrawElements(GL_PATCHES, std::min(most_indices, index_count_ - first), GL_UNSIGNED_INT,
                             offset(static_cast<std::size_t>(first) * sizeof(std::uint32_t)));
            }
          }};
}

Competitor Subject::touched(const Competitor& competitor) const {
  return {competitor.prepare, [this, draw_one = competitor.draw] {
            glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(float), first_vertex_.position);
            draw_one();
          }};
}

Competitor Subject::moving(const Competitor& competitor) const {
  const auto matrix = std::make_shared<std::array<GLfloat, 16>>();
  const auto location = std::make_shared<GLint>();
  return {[=] {
            competitor.prepare();
            GLint program = 0;
            glGetIntegerv(GL_CURRENT_PROGRAM, &program);
            const auto name = static_cast<GLuint>(program);
            *location = glGetUniformLocation(name, "projection");
            glGetUniformfv(name, *location, matrix->data());
          },
          [=] {
            (*matrix)[0] *= 1.000001F;
            glUniformMatrix4fv(*location, 1, GL_FALSE, matrix->data());
            competitor.draw();
          }};
}

}  // namespace glark::bench
