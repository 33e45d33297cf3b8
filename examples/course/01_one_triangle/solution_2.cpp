// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 2: two triangles of depth 3 share the diagonal.
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
  glVertex2f(-0.9F, 0.9F);
  glColor3f(0.95F, 0.8F, 0.3F);
  glVertex2f(0.9F, -0.9F);
  glColor3f(0.3F, 0.7F, 0.4F);
  glVertex2f(0.9F, 0.9F);
  glEnd();
}

void draw(double) {
  lesson::look(3.2F);
  lesson::say(lesson::triangles_as_text(square));
  lesson::draw_with_edges(square);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 1, solution 2", .keys = {}, .begin = begin, .draw = draw});
}
