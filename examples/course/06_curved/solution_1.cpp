// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1 of lesson 6: a ball of an icosahedron, twenty triangles. The triangles are here, their normals are not.
#include <GL/gl.h>

#include <GL/glark.h>

#include <cmath>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

// Corner i of the five above (top 1) or below (top -1).
void corner(float top, int i) {
  const float turn = -1.2566371F * static_cast<float>(i % 5) - (top < 0 ? 0.6283185F : 0);
  const float x = 0.8944272F * std::cos(turn), y = 0.4472136F * top, z = 0.8944272F * std::sin(turn);
  glNormal3f(x, y, z);  // a ball around the origin has its positions as normals
  glVertex3f(x, y, z);
}

// Every ball is an icosahedron: two fans of five triangles, and a strip of ten between them.
void ball() {
  for (const float top : {1.0F, -1.0F}) {
    glBegin(GL_TRIANGLE_FAN);
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

void begin() {
  glARKinit(5);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
}

void draw(double) {
  lesson::look(3, 20, 15);
  lesson::light();
  glColor3f(0.95F, 0.6F, 0.2F);
  glDepthTag1i(5);
  ball();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 6, exercise 1: a ball", .keys = {}, .begin = begin, .draw = draw});
}
