// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2: a second triangle completes the square. Its new corner is at (0.9, 0.9), in colour (0.3, 0.7, 0.4).
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"

namespace {

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
}

void square() {
  glDepthTag1i(3);
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.45F, 0.25F);
  glVertex2f(-0.9F, -0.9F);
  glColor3f(0.95F, 0.8F, 0.3F);
  glVertex2f(0.9F, -0.9F);
  glColor3f(0.3F, 0.5F, 0.9F);
  glVertex2f(-0.9F, 0.9F);
  // Write the second triangle here. It shares two corners, with their colours, with the first.
  glEnd();
}

void draw(double) {
  lesson::look(3.2F);
  lesson::say(lesson::triangles_as_text(square));
  lesson::draw_with_edges(square);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 1, exercise 2", .keys = {}, .begin = begin, .draw = draw});
}
