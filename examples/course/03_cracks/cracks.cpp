// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 3: cracks. A vertex of the right side lies on the middle of an edge of the left side: a T-vertex.
// The two sides fit if the long edge has as many segments as its two halves together.
#include "examples/course/03_cracks/hill.h"

#include <algorithm>

namespace {

unsigned left = 0, right = 0;  // depth tags

void mesh() {
  // [draw]
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
  // [/draw]
}

void draw(double) {
  const char* const result = hill::draw(mesh, std::max(left, right));
  lesson::say("left %u, right %u: %s", left, right, result);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 3, cracks",
                      .keys = {{'l', "the next tag of the left side", [] { left = (left + 1) % 7; }},
                               {'r', "the next tag of the right side", [] { right = (right + 1) % 7; }}},
                      .begin = hill::begin,
                      .draw = draw});
}
