// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 9: measured depth. A row of balls leads away from the eye. Nobody sets a tag: every edge is measured on the
// screen, within a budget of triangles, and with geomorphing no vertex pops while the eye moves.
#include <GL/gl.h>

#include <GL/glark.h>

#include <cmath>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr unsigned deepest = 6;
constexpr int balls = 8;
int edge_pixels = 12, budget = 0;
bool measured = true, geomorph = false, wireframe = true;

// Corner i of the five above (top 1) or below (top -1). A ball around the origin has its positions as normals.
void corner(float top, int i) {
  const float turn = -1.2566371F * static_cast<float>(i % 5) - (top < 0 ? 0.6283185F : 0);
  const float x = 0.8944272F * std::cos(turn), y = 0.4472136F * top, z = 0.8944272F * std::sin(turn);
  glNormal3f(x, y, z);
  glVertex3f(x, y, z);
}

// Every ball is an icosahedron: two fans of five triangles, and a strip of ten between them.
void draw_ball() {
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

void draw_row() {
  for (int i = 0; i < balls; ++i) {
    glPushMatrix();
    glTranslatef(i % 2 == 0 ? -1.3F : 1.3F, 0, 1.5F - 2.6F * static_cast<float>(i));
    draw_ball();
    glPopMatrix();
  }
}

// [depth]
void choose_depth() {
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, measured ? GL_MEASURED_DEPTH_ARK : GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, deepest);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, edge_pixels);  // no segment of an edge is longer on the screen
  glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, budget);   // 0: no budget
  glARKParameteriARK(GL_GEOMORPH_ARK, geomorph ? GL_TRUE : GL_FALSE);
}
// [/depth]

// [draw]
void draw(double seconds) {
  choose_depth();
  lesson::look(6.5F - 2 * std::sin(static_cast<float>(seconds)), 0, 22);
  lesson::light();
  glColor3f(0.35F, 0.7F, 0.45F);
  lesson::say(lesson::triangles_as_text(draw_row));
  if (wireframe) lesson::draw_with_edges(draw_row);
  if (!wireframe) draw_row();
}
// [/draw]

void begin() {
  glEnable(GL_CULL_FACE);
  glARKinit(deepest);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glEnable(GL_ARK);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 9: measured depth",
                      .keys = {{'m', "measured depth, or depth 6 everywhere", [] { measured = !measured; }},
                               {'p', "longer edges on the screen", [] { edge_pixels *= 2; }},
                               {'P', "shorter edges on the screen", [] { edge_pixels -= edge_pixels / 2; }},
                               {'b', "budget: none, or 3000 triangles", [] { budget = budget == 0 ? 3000 : 0; }},
                               {'g', "geomorphing", [] { geomorph = !geomorph; }},
                               {'w', "wireframe", [] { wireframe = !wireframe; }}},
                      .begin = begin,
                      .draw = draw});
}
