// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1: choose the depth that makes 1024 triangles.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"

namespace {

constexpr unsigned depth = 2;  // change this

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
}

void triangle() {
  glDepthTag1i(depth);
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.45F, 0.25F);
  glVertex2f(-1, -0.8F);
  glColor3f(0.3F, 0.7F, 0.4F);
  glVertex2f(1, -0.8F);
  glColor3f(0.3F, 0.5F, 0.9F);
  glVertex2f(0, 0.9F);
  glEnd();
}

void draw(double) {
  lesson::look(3.2F);
  lesson::say(lesson::triangles_as_text(triangle));
  lesson::draw_with_edges(triangle);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 1, exercise 1", .keys = {}, .begin = begin, .draw = draw});
}
