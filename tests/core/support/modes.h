// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A coloured shape in each mode of triangles.
#pragma once

#include <array>
#include <ostream>
#include <vector>

#include "tests/core/support/gl.h"

namespace glark::core::test {

struct ColoredVertex {
  std::array<GLfloat, 2> position;
  std::array<GLfloat, 3> color;
};

struct ModeShape {
  const char* name;
  GLenum mode;
  GLuint triangles;
  std::vector<ColoredVertex> vertices;
};

inline std::ostream& operator<<(std::ostream& out, const ModeShape& shape) { return out << shape.name; }

inline const ColoredVertex zigzag[6] = {{{-0.9F, -0.8F}, {1, 0, 0}}, {{-0.8F, 0.7F}, {0, 1, 0}},
                                        {{0.0F, -0.9F}, {0, 0, 1}},  {{0.1F, 0.9F}, {1, 1, 0}},
                                        {{0.8F, -0.6F}, {0, 1, 1}},  {{0.9F, 0.8F}, {1, 0, 1}}};
inline const ColoredVertex hexagon[6] = {{{-0.9F, 0.1F}, {1, 0, 0}}, {{-0.5F, -0.8F}, {0, 1, 0}},
                                         {{0.4F, -0.9F}, {0, 0, 1}}, {{0.9F, -0.1F}, {1, 1, 0}},
                                         {{0.5F, 0.8F}, {0, 1, 1}},  {{-0.4F, 0.9F}, {1, 0, 1}}};

// Colours that are affine in the position: drivers cut quads along either diagonal.
inline ColoredVertex affine(ColoredVertex vertex) {
  const auto [x, y] = vertex.position;
  return {vertex.position, {0.5F + 0.5F * x, 0.5F + 0.5F * y, 0.5F + 0.25F * (x - y)}};
}

inline const std::vector<ModeShape>& mode_shapes() {
  static const std::vector<ModeShape> shapes = {
      {"triangles", GL_TRIANGLES, 2, {zigzag[0], zigzag[2], zigzag[1], zigzag[3], zigzag[4], zigzag[5]}},
      {"triangle_strip", GL_TRIANGLE_STRIP, 4, {zigzag[0], zigzag[1], zigzag[2], zigzag[3], zigzag[4], zigzag[5]}},
      {"triangle_fan", GL_TRIANGLE_FAN, 4, {hexagon[0], hexagon[1], hexagon[2], hexagon[3], hexagon[4], hexagon[5]}},
      {"quads",
       GL_QUADS,
       4,
       {affine(zigzag[0]), affine(zigzag[2]), affine(zigzag[3]), affine(zigzag[1]), affine(zigzag[2]),
        affine(zigzag[4]), affine(zigzag[5]), affine(zigzag[3])}},
      {"quad_strip",
       GL_QUAD_STRIP,
       4,
       {affine(zigzag[0]), affine(zigzag[1]), affine(zigzag[2]), affine(zigzag[3]), affine(zigzag[4]),
        affine(zigzag[5])}},
      {"polygon", GL_POLYGON, 4, {hexagon[0], hexagon[1], hexagon[2], hexagon[3], hexagon[4], hexagon[5]}},
  };
  return shapes;
}

// The modes that every profile has.
inline std::vector<ModeShape> triangle_shapes() { return {mode_shapes().begin(), mode_shapes().begin() + 3}; }

inline void emit(const ColoredVertex& vertex) {
  glColor3fv(vertex.color.data());
  glVertex2fv(vertex.position.data());
}

inline void draw_immediate(const ModeShape& shape) {
  glBegin(shape.mode);
  for (const ColoredVertex& vertex : shape.vertices) emit(vertex);
  glEnd();
}

inline void point_conventional_arrays(const void* base) {
  const char* const bytes = static_cast<const char*>(base);
  glVertexPointer(2, GL_FLOAT, sizeof(ColoredVertex), bytes);
  glColorPointer(3, GL_FLOAT, sizeof(ColoredVertex), bytes + sizeof(ColoredVertex::position));
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
}

// Attributes 0 (position) and 1 (colour).
inline void point_generic_arrays(const void* base) {
  const char* const bytes = static_cast<const char*>(base);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), bytes);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), bytes + sizeof(ColoredVertex::position));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
}

}  // namespace glark::core::test
