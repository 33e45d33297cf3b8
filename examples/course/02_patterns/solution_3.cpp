// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 3: a smooth interior has a middle row where depths differ by 3 or more.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"

namespace {

constexpr unsigned tags[3] = {5, 0, 6};

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK);
}

void triangle() {
  constexpr float corners[3][2] = {{-1, -0.8F}, {1, -0.8F}, {0, 0.9F}};
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    glDepthTag1i(tags[i]);
    glVertex2fv(corners[i]);
  }
  glEnd();
}

void draw(double) {
  lesson::look(3.2F);
  lesson::say(lesson::triangles_as_text(triangle));
  glColor3f(0.7F, 0.82F, 0.95F);
  lesson::draw_with_edges(triangle);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 2, solution 3", .keys = {}, .begin = begin, .draw = draw});
}
