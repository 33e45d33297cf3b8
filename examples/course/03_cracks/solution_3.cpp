// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 3: no tag puts a vertex at z = 0.3. The left side needs this vertex, too, and then both sides have the same
// edges.
#include "examples/course/03_cracks/hill.h"

namespace {

constexpr unsigned tag = 4;

void mesh() {
  glDepthTag1i(tag);
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.75F, 0.4F);
  glVertex3f(0, 0, -1);
  glVertex3f(-1.2F, 0, 0);
  glVertex3f(0, 0, 0.3F);
  glVertex3f(0, 0, 0.3F);
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
  return lesson::run(argc, argv, {.title = "Lesson 3, solution 3", .keys = {}, .begin = hill::begin, .draw = draw});
}
