// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3 of lesson 10: a program that does not know glark. It draws a tower of six sides. `glark run --refine pn`
// makes its draws round, but only where normals say that they are round. Mend the normals, not the refinement.
#include <GL/gl.h>

#include <array>
#include <cmath>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int sides = 6;
constexpr std::array<float, 5> radii = {0.9F, 0.6F, 0.45F, 0.5F, 0.75F};

void corner(int side, std::size_t ring, float normal_turn) {
  const float turn = -6.2831853F * static_cast<float>(side) / sides;
  glNormal3f(std::cos(normal_turn), 0.2F, std::sin(normal_turn));
  glVertex3f(radii[ring] * std::cos(turn), 0.5F * static_cast<float>(ring) - 1, radii[ring] * std::sin(turn));
}

// [side]
void draw_side(int side) {
  const auto turn_of = [](float corner) { return -6.2831853F * corner / sides; };
  const auto here = static_cast<float>(side);
  glBegin(GL_TRIANGLE_STRIP);
  for (std::size_t ring = 0; ring < radii.size(); ++ring) {
    corner(side, ring, turn_of(here));
    corner(side + 1, ring, turn_of(here + 1));
  }
  glEnd();
}
// [/side]

void draw(double) {
  lesson::look(4, 10, 20);
  lesson::light();
  glColor3f(0.7F, 0.7F, 0.75F);
  for (int side = 0; side < sides; ++side) draw_side(side);
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 10, exercise 3: a tower", .keys = {}, .begin = {}, .draw = draw});
}
