// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2 of lesson 9: a budget. Edges of 4 pixels make many triangles. Set a budget so that a frame has at most
// 2000 of them. The extension learns from one frame for the next, so the program draws thirty frames.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <cmath>
#include <string>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

// Corner i of the five above (top 1) or below (top -1). A ball around the origin has its positions as normals.
void corner(float top, int i) {
  const float turn = -1.2566371F * static_cast<float>(i % 5) - (top < 0 ? 0.6283185F : 0);
  const float x = 0.8944272F * std::cos(turn), y = 0.4472136F * top, z = 0.8944272F * std::sin(turn);
  glNormal3f(x, y, z);
  glVertex3f(x, y, z);
}

// Every ball is an icosahedron: two fans of five triangles, and a strip of ten between them.
void ball() {
  for (const float top : {1.0F, -1.0F}) {
    glBegin(GL_TRIANGLE_FAN);
    glNormal3f(0, top, 0);
    glVertex3f(0, top, 0);
    for (int i = 0; i <= 5; ++i) corner(top, top > 0 ? i : 5 - i);
    glEnd();
  }
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i <= 5; ++i) {
    corner(1, i);
    corner(-1, i);
  }
  glEnd();
}

void begin() {
  glEnable(GL_CULL_FACE);
  glARKinit(6);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 4);
  glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 2000);
}

void draw(double) {
  lesson::look(3, 20, 15);
  lesson::light();
  glColor3f(0.6F, 0.55F, 0.85F);
  unsigned triangles = 0;
  for (int frame = 0; frame < 30; ++frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    ball();
    triangles = lesson::count_triangles(ball);
    glFinish();  // without a window, this ends a frame
  }
  ball();
  lesson::say(triangles <= 2000 ? "within the budget" : std::to_string(triangles) + " triangles are too many");
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 9, exercise 2: a budget", .keys = {}, .begin = begin, .draw = draw});
}
