// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 2: patterns. The corners have tags, the edges get depths, and a pattern fits every triple of depths.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include <array>

#include "examples/common/look.h"

namespace {

// [tags]
std::array<unsigned, 3> tags = {2, 2, 2};  // of the corners: left, right, top

unsigned depth_of_edge(unsigned a, unsigned b) { return (tags[a] + tags[b]) / 2; }
// [/tags]

void raise(unsigned corner) { tags[corner] = tags[corner] == 6 ? 0 : tags[corner] + 1; }

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
}

void triangle() {
  // [draw]
  constexpr float corners[3][2] = {{-1, -0.8F}, {1, -0.8F}, {0, 0.9F}};
  glBegin(GL_TRIANGLES);
  for (unsigned i = 0; i < 3; ++i) {
    glDepthTag1i(tags[i]);
    glVertex2fv(corners[i]);
  }
  glEnd();
  // [/draw]
}

void draw(double) {
  lesson::look(3.2F);
  lesson::say("tags %u %u %u, depths of the edges %u %u %u: %s", tags[0], tags[1], tags[2], depth_of_edge(0, 1),
              depth_of_edge(1, 2), depth_of_edge(2, 0), lesson::triangles_as_text(triangle).c_str());
  glColor3f(0.7F, 0.82F, 0.95F);
  lesson::draw_with_edges(triangle);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 2, patterns",
                      .keys = {{'1', "the next tag of the left corner", [] { raise(0); }},
                               {'2', "the next tag of the right corner", [] { raise(1); }},
                               {'3', "the next tag of the top corner", [] { raise(2); }}},
                      .begin = begin,
                      .draw = draw});
}
