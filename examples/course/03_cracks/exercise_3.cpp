// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3: the T-vertex is at z = 0.3, not in the middle of the edge. Which tags close this crack? If none do,
// change the triangles.
#include "examples/course/03_cracks/hill.h"

namespace {

constexpr unsigned tag = 4;  // try all from 0 to 4

void mesh() {
  glDepthTag1i(tag);
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.75F, 0.4F);
  glVertex3f(0, 0, -1);
  glVertex3f(-1.2F, 0, 0);
  glVertex3f(0, 0, 1);
  glColor3f(0.5F, 0.75F, 0.55F);
  glVertex3f(0, 0, -1);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(1.2F, 0, 0);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(0, 0, 1);
  glVertex3f(1.2F, 0, 0);
  glEnd();
}

void draw(double) {
  const char* const result = hill::draw(mesh, tag);
  lesson::say(lesson::triangles_as_text(mesh) + ", " + result);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 3, exercise 3", .keys = {}, .begin = hill::begin, .draw = draw});
}
