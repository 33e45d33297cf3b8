// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A program that captures its refined positions or normals, and vertices with scalar tags.
#pragma once

#include <random>

#include "glark/pn.h"
#include "tests/core/support/refined_capture.h"

namespace glark::pn::test {

using namespace glark::core::test;

enum class Shown { position, normal };

// Attributes: 0 position, 1 normal, 2 weights, 3 triangle.
inline GLuint link_tagged_program(Shown shown) {
  const std::string value = shown == Shown::position ? "position" : "normal";
  return link_program(
      {.vertex = "#version 450 core\nin vec3 position; in vec3 normal; in vec3 weights; in float triangle;\n"
                 "out vec3 passed_weights; out float passed_triangle;\n"
                 "void main() { gl_Position = vec4(" +
                 value +
                 ", position.x + normal.x);\n"
                 "  passed_weights = weights; passed_triangle = triangle; }\n",
       .fragment = "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n",
       .varyings = {"gl_Position", "passed_weights", "passed_triangle"},
       .attributes = {"position", "normal", "weights", "triangle"}});
}

struct TaggedVertex {
  Corner corner;
  std::array<GLfloat, 3> weights = {};
  GLfloat triangle = 0;
  GLubyte depth = 0;
};
using Triangle = std::array<Corner, 3>;

inline void append(std::vector<TaggedVertex>& mesh, const Triangle& corners, int number,
                   const std::array<int, 3>& depths = {3, 3, 3}, int rotation = 0) {
  for (int k = 0; k < 3; ++k) {
    const auto corner = static_cast<std::size_t>((k + rotation) % 3);
    TaggedVertex vertex{corners[corner], {}, static_cast<GLfloat>(number), static_cast<GLubyte>(depths[corner])};
    vertex.weights[corner] = 1;
    mesh.push_back(vertex);
  }
}

// Points all attributes into a new buffer.
inline void upload(const std::vector<TaggedVertex>& vertices) {
  make_buffer(GL_ARRAY_BUFFER, vertices);
  const auto point = [](GLint name, GLint components, std::size_t offset) {
    glVertexAttribPointer(static_cast<GLuint>(name), components, GL_FLOAT, GL_FALSE, sizeof(TaggedVertex),
                          byte_offset(offset));
    glEnableVertexAttribArray(static_cast<GLuint>(name));
  };
  GLint discontinuity = 0;
  GLint tags = 0;
  glGetIntegerv(GL_DISCONTINUITY_ATTRIBUTE_ARK, &discontinuity);
  glGetIntegerv(GL_SCALAR_TAG_ATTRIBUTE_ARK, &tags);
  point(0, 3, offsetof(TaggedVertex, corner.position));
  point(1, 3, offsetof(TaggedVertex, corner.normal));
  point(2, 3, offsetof(TaggedVertex, weights));
  point(3, 1, offsetof(TaggedVertex, triangle));
  point(discontinuity, 4, offsetof(TaggedVertex, corner.discontinuity));
  point(tags, 3, offsetof(TaggedVertex, corner.tags));
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, sizeof(TaggedVertex), byte_offset(offsetof(TaggedVertex, depth)));
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
}

// Corners with random data; some have tags at and beyond their limits.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  float number(float least, float most) { return std::uniform_real_distribution<float>(least, most)(engine_); }
  int whole(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  Corner corner(bool tagged) {
    Corner c;
    for (float& x : c.position) x = number(-1, 1);
    for (float& x : c.normal) x = number(-1, 1);
    if (tagged) {
      for (std::size_t i = 0; i < 3; ++i) c.discontinuity[i] = number(-1, 1);
      c.discontinuity[3] = static_cast<float>(whole(3));
    }
    const std::array<float, 3> limits = {whole(4) == 0 ? 0.0F : number(-0.2F, 2), number(-1.2F, 1.2F),
                                         number(-1.2F, 1.2F)};
    c.tags = limits;
    return c;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace glark::pn::test
