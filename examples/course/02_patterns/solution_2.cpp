// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Solution 2: interior (n - 3)^2, and from n - 3 inner segments to the 2^a of an edge: 2^a + n - 3 triangles, for each
// edge.
#include "examples/common/lesson.h"

#include <GL/gl.h>
#include <GL/glark.h>

#include <algorithm>

namespace {

// The number of triangles of the pattern with the depths a, b and c.
unsigned formula(unsigned a, unsigned b, unsigned c) {
  const unsigned n = 1U << std::min({a, b, c});
  return n * n + (1U << a) + (1U << b) + (1U << c) - 3 * n;
}

unsigned tags[3];

void triangle() {
  glBegin(GL_TRIANGLES);
  for (const unsigned tag : tags) {
    glDepthTag1i(tag);
    glVertex2f(0, 0);
  }
  glEnd();
}

void begin() {
  glARKinit(6);
  glEnable(GL_ARK);
}

// Draws one triangle for every triple of tags, and compares the number of triangles with the formula.
void draw(double) {
  unsigned triples = 0;
  unsigned right = 0;
  for (unsigned triple = 0; triple < 5 * 5 * 5; ++triple) {
    tags[0] = triple % 5;
    tags[1] = triple / 5 % 5;
    tags[2] = triple / 25;
    const unsigned drawn = lesson::count_triangles(triangle);
    ++triples;
    if (drawn == formula((tags[0] + tags[1]) / 2, (tags[1] + tags[2]) / 2, (tags[2] + tags[0]) / 2)) ++right;
  }
  lesson::say("the formula is right for %u of %u triples", right, triples);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 2, solution 2", .keys = {}, .begin = begin, .draw = draw});
}
