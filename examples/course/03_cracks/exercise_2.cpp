// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2: the far corners at x = -1.2 and x = 1.2 lie on flat ground. Give them the tag 1, and open no crack.
#include "examples/course/03_cracks/hill.h"

namespace {

void mesh() {
  // A tag counts for all vertices after it.
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.75F, 0.4F);
  glDepthTag1i(5);
  glVertex3f(0, 0, -1);
  glVertex3f(-1.2F, 0, 0);
  glVertex3f(0, 0, 1);
  glColor3f(0.5F, 0.75F, 0.55F);
  glDepthTag1i(4);
  glVertex3f(0, 0, -1);
  glVertex3f(0, 0, 0);
  glVertex3f(1.2F, 0, 0);
  glVertex3f(0, 0, 0);
  glVertex3f(0, 0, 1);
  glVertex3f(1.2F, 0, 0);
  glEnd();
}

void draw(double) {
  const char* const result = hill::draw(mesh);
  lesson::say("%u triangles, %s", lesson::count_triangles(mesh), result);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 3, exercise 2", .keys = {}, .begin = hill::begin, .draw = draw});
}
