// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 1 of lesson 9: measure. The two balls far away get as many triangles as the ball in front. Let the extension
// measure: no segment of an edge should be longer than 8 pixels.
#include <GL/gl.h>

#include <GL/glark.h>

#include <cmath>

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

void balls() {
  for (const float away : {0.0F, 6.0F, 14.0F}) {
    glPushMatrix();
    glTranslatef(0.25F * away - 1, 0, -away);
    ball();
    glPopMatrix();
  }
}

void begin() {
  glEnable(GL_CULL_FACE);
  glARKinit(6);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);  // TODO
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 5);
}

void draw(double) {
  lesson::look(4.5F, 0, 15);
  lesson::light();
  glColor3f(0.9F, 0.8F, 0.4F);
  lesson::say(lesson::triangles_as_text(balls));
  lesson::draw_with_edges(balls);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 9, exercise 1: measure", .keys = {}, .begin = begin, .draw = draw});
}
