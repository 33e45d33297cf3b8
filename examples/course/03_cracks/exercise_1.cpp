// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1: close the crack. The left side keeps its depth.
#include "examples/course/03_cracks/hill.h"

#include <algorithm>

namespace {

constexpr unsigned left = 4;
constexpr unsigned right = 5;  // change this

void mesh() {
  glBegin(GL_TRIANGLES);
  glDepthTag1i(left);  // one large triangle on the left: its edge runs from z = -1 to z = 1
  glColor3f(0.95F, 0.75F, 0.4F);
  glVertex3f(0, 0, -1);
  glVertex3f(-1.2F, 0, 0);
  glVertex3f(0, 0, 1);
  glDepthTag1i(right);  // two triangles on the right: there is a vertex at z = 0
  glColor3f(0.5F, 0.75F, 0.55F);
  glVertex3f(0, 0, -1);
  glVertex3f(0, 0, 0);
  glVertex3f(1.2F, 0, 0);
  glVertex3f(0, 0, 0);
  glVertex3f(0, 0, 1);
  glVertex3f(1.2F, 0, 0);
  glEnd();
}

void draw(double) { lesson::say("%s", hill::draw(mesh, std::max(left, right))); }

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 3, exercise 1", .keys = {}, .begin = hill::begin, .draw = draw});
}
