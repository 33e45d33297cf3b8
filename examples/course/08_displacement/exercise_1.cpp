// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1 of lesson 8: a planet. The height map is bound, but the ball is smooth. Heights go from 0 to 1; the ball
// has radius 1. The lowest place should lie at radius 0.9, the highest at 1.15.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int map_size = 128;

void upload_height_map() {
  std::vector<float> heights;
  for (int t = 0; t < map_size; ++t) {
    for (int s = 0; s < map_size; ++s) {
      const float a = 6.2831853F * static_cast<float>(s) / map_size, b = 6.2831853F * static_cast<float>(t) / map_size;
      const float hills =
          0.5F + 0.3F * std::sin(a + std::cos(2 * b)) * std::cos(b) + 0.2F * std::sin(3 * a) * std::sin(2 * b + 1);
      heights.push_back(std::pow(hills, 1.5F));
    }
  }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map_size, map_size, 0, GL_RED, GL_FLOAT, heights.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

void begin() {
  upload_height_map();
  glARKinit(6);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  // TODO: texture image unit 0 has the map; choose the scale and the bias of heights
}

// Corner i of the five above (top 1) or below (top -1). A ball around the origin has its positions as normals.
void corner(float top, int i) {
  const float turn = -1.2566371F * static_cast<float>(i % 5) - (top < 0 ? 0.6283185F : 0);
  const float x = 0.8944272F * std::cos(turn), y = 0.4472136F * top, z = 0.8944272F * std::sin(turn);
  glTexCoord2f(0.5F * x, 0.5F * y);  // the front and the back are alike, so there is no seam
  glNormal3f(x, y, z);
  glVertex3f(x, y, z);
}

// Every ball is an icosahedron: two fans of five triangles, and a strip of ten between them.
void ball() {
  for (const float top : {1.0F, -1.0F}) {
    glBegin(GL_TRIANGLE_FAN);
    glTexCoord2f(0, 0.5F * top);
    glNormal3f(0, top, 0);
    glVertex3f(0, top, 0);
    for (int i = 0; i <= 5; ++i) corner(top, top > 0 ? i : 5 - i);
    glEnd();
  }
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i <= 5; ++i) {
    corner(1, i);
    corner(-1, i);
  }
  glEnd();
}

void draw(double) {
  lesson::look(3.2F, 20, 20);
  lesson::light();
  glDepthTag1i(6);
  glColor3f(0.75F, 0.6F, 0.45F);
  ball();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 8, exercise 1: a planet", .keys = {}, .begin = begin, .draw = draw});
}
