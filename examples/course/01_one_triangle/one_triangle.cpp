// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 1: one triangle. Its depth tag d makes 2^d segments of every edge, so 4^d triangles of one.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include "examples/common/look.h"

namespace {

unsigned depth = 0;
constexpr unsigned deepest = 5;

void begin() {
  // [begin]
  glARKinit(deepest);  // patterns for edges of up to 2^5 segments
  glEnable(GL_ARK);    // from here on, patterns replace triangles
  // [/begin]
}

void triangle() {
  // [draw]
  glDepthTag1i(depth);  // the next vertices ask for 2^depth segments on every edge
  glBegin(GL_TRIANGLES);
  glColor3f(0.95F, 0.45F, 0.25F);
  glVertex2f(-1, -0.8F);
  glColor3f(0.3F, 0.7F, 0.4F);
  glVertex2f(1, -0.8F);
  glColor3f(0.3F, 0.5F, 0.9F);
  glVertex2f(0, 0.9F);
  glEnd();
  // [/draw]
}

void draw(double) {
  lesson::look(3.2F);
  // [count]
  lesson::say("depth %u: %s", depth, lesson::triangles_as_text(triangle).c_str());
  // [/count]
  lesson::draw_with_edges(triangle);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 1, one triangle",
                      .keys = {{'d', "one level deeper", [] { depth = depth < deepest ? depth + 1 : depth; }},
                               {'s', "one level shallower", [] { depth = depth > 0 ? depth - 1 : depth; }}},
                      .begin = begin,
                      .draw = draw});
}
