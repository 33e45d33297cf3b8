// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3 of lesson 9: no popping. The eye comes closer in many steps. A query counts how much of the picture the
// ball covers. If an edge gains a whole level in one step, the ball grows suddenly. It should grow little by little.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <algorithm>
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
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 40);
  glARKParameteriARK(GL_GEOMORPH_ARK, GL_TRUE);
}

// The area of the ball on the screen. It is scaled by the distance, so that a perfect ball always has the same area.
float area_from(float distance) {
  GLuint query = 0, samples = 0;
  glGenQueries(1, &query);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  lesson::look(distance, 20, 15);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  ball();
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  glDeleteQueries(1, &query);
  return static_cast<float>(samples) * (distance * distance - 1);
}

void draw(double) {
  constexpr float step = 0.99F;
  lesson::light();
  glColor3f(0.85F, 0.55F, 0.6F);
  float greatest = 0;
  float before = area_from(9);
  for (float distance = 9 * step; distance > 3; distance *= step) {
    const float now = area_from(distance);
    greatest = std::max(greatest, std::abs(now / before - 1));
    before = now;
  }
  if (greatest > 0.012F) lesson::say("the ball jumps by " + std::to_string(100 * greatest) + " percent");
  if (greatest <= 0.012F) lesson::say("the ball grows little by little");
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 9, exercise 3: no popping", .keys = {}, .begin = begin, .draw = draw});
}
