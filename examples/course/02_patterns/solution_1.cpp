// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 1: (6 + 0) / 2 = 3, (0 + 2) / 2 = 1, (2 + 6) / 2 = 4.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"

namespace {

constexpr unsigned tags[3] = {6, 0, 2};

unsigned depth_of_edge(int a, int b) { return (tags[a] + tags[b]) / 2; }

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
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
  lesson::say("depths of the edges %u %u %u: %s", depth_of_edge(0, 1), depth_of_edge(1, 2), depth_of_edge(2, 0),
              lesson::triangles_as_text(triangle).c_str());
  glColor3f(0.7F, 0.82F, 0.95F);
  lesson::draw_with_edges(triangle);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 2, solution 1", .keys = {}, .begin = begin, .draw = draw});
}
