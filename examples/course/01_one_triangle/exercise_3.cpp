// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3: a tag for every corner. The two corners at the bottom get 2, the corner at the top gets 6.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"

namespace {

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
}

void triangle() {
  glBegin(GL_TRIANGLES);
  // glDepthTag1i may stand before every vertex.
  glDepthTag1i(2);
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
  return lesson::run(argc, argv, {.title = "Lesson 1, exercise 3", .keys = {}, .begin = begin, .draw = draw});
}
