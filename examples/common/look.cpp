// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#define GL_GLEXT_PROTOTYPES
#include "examples/common/look.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <cmath>

#include "examples/common/frame.h"

namespace lesson {
namespace {

constexpr float pi = 3.14159265F;

Matrix rotation(float degrees, int axis) {
  const float c = std::cos(degrees * pi / 180);
  const float s = std::sin(degrees * pi / 180);
  if (axis == 0) return {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1};
  return {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1};
}

}  // namespace

Matrix multiply(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t column = 0; column < 4; ++column)
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t k = 0; k < 4; ++k) product[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return product;
}

void use_part(int part, int parts) {
  const int width = view().width / parts;
  glViewport(part * width, 0, width, view().height);
  view().aspect = static_cast<float>(width) / static_cast<float>(view().height);
}

Camera camera(float distance, float turn, float tilt) {
  constexpr float focus = 2.5F;  // an angle of 44 degrees, from top to bottom or from left to right if that is less
  const float wide = std::max(view().aspect, 1.0F);
  const float high = std::max(1 / view().aspect, 1.0F);
  const float near = distance / 50;
  const float far = distance * 10;
  const Matrix projection{
      focus / view().aspect,         0, 0, 0, 0, focus, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
      2 * far * near / (near - far), 0};
  Matrix model = multiply(rotation(tilt + view().tilt, 0), rotation(turn + view().turn, 1));
  model[14] -= distance;
  return {projection, model};
}

void look(float distance, float turn, float tilt) {
  const Camera eye = camera(distance, turn, tilt);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(eye.projection.data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(eye.view.data());
}

void light() {
  constexpr float position[4] = {-0.5F, 0.7F, 0.8F, 0};
  constexpr float shine[4] = {0.6F, 0.6F, 0.6F, 1};
  glPushMatrix();
  glLoadIdentity();  // the light stays with the eye
  glLightfv(GL_LIGHT0, GL_POSITION, position);
  glPopMatrix();
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40);
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  for (const GLenum capability : {GL_COLOR_MATERIAL, GL_NORMALIZE, GL_LIGHT0, GL_LIGHTING, GL_DEPTH_TEST})
    glEnable(capability);
}

void draw_with_edges(const std::function<void()>& draw) {
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_CONSTANT_COLOR);  // only the constant colour counts, whatever `draw` sets
  glBlendColor(0.4F, 0.4F, 0.5F, 1);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  draw();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDisable(GL_BLEND);
}

}  // namespace lesson
