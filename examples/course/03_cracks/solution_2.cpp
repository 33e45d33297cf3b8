// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 2: only the tags of the common edge have to fit.
#include "examples/course/03_cracks/hill.h"

namespace {

constexpr unsigned left = 4, right = 3;  // the tags of the border

void mesh() {
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.75F, 0.4F);
  glDepthTag1i(left);
  glVertex3f(0, 0, -1);
  glDepthTag1i(1);
  glVertex3f(-1.2F, 0, 0);
  glDepthTag1i(left);
  glVertex3f(0, 0, 1);
  glColor3f(0.5F, 0.75F, 0.55F);
  glDepthTag1i(right);
  glVertex3f(0, 0, -1);
  glVertex3f(0, 0, 0);
  glDepthTag1i(1);
  glVertex3f(1.2F, 0, 0);
  glDepthTag1i(right);
  glVertex3f(0, 0, 0);
  glVertex3f(0, 0, 1);
  glDepthTag1i(1);
  glVertex3f(1.2F, 0, 0);
  glEnd();
}

void draw(double) {
  const char* const result = hill::draw(mesh, left);
  lesson::say(lesson::triangles_as_text(mesh) + ", " + result);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 3, solution 2", .keys = {}, .begin = hill::begin, .draw = draw});
}
