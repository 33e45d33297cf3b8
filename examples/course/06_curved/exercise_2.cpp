// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2 of lesson 6: close the gap between the lids and the wall of a hexagonal column. The column stays hard
// where the lids begin. The line that does it stands in begin().
#include <GL/gl.h>

#include <GL/glark.h>

#include <cmath>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int sides = 6;

void corner(float turn, float y, bool lid) {
  const float x = std::cos(turn), z = std::sin(turn);
  glNormal3f(lid ? 0 : x, lid ? y : 0, lid ? 0 : z);
  glVertex3f(0.7F * x, 0.9F * y, 0.7F * z);
}

// All triangles stand between one glBegin and one glEnd: they are one draw.
void column() {
  glColor3f(0.5F, 0.65F, 0.85F);
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < sides; ++i) {
    const float here = 6.2831853F * static_cast<float>(i) / sides;
    const float next = 6.2831853F * static_cast<float>((i + 1) % sides) / sides;
    corner(here, 1, false);
    corner(next, 1, false);
    corner(here, -1, false);
    corner(here, -1, false);
    corner(next, 1, false);
    corner(next, -1, false);
    for (const float y : {1.0F, -1.0F}) {
      glNormal3f(0, y, 0);
      glVertex3f(0, 0.9F * y, 0);
      corner(y > 0 ? next : here, y, true);
      corner(y > 0 ? here : next, y, true);
    }
  }
  glEnd();
}

void begin() {
  glARKinit(5);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  // TODO: vertices in the same place must refine alike
}

void draw(double) {
  lesson::look(3.4F, 15, 35);
  lesson::light();
  glDepthTag1i(5);
  column();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 6, exercise 2: a gap", .keys = {}, .begin = begin, .draw = draw});
}
