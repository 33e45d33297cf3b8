// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3 of lesson 10: a program that does not know glark. It draws a tower of six sides. `glark run --refine pn`
// makes its draws round, but only where normals say that they are round. Mend the normals, not the refinement.
#include <GL/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int sides = 6;
constexpr std::array<float, 5> radii = {0.9F, 0.6F, 0.45F, 0.5F, 0.75F};

// A corner of the tower, with a normal that points away from the axis in the direction `normal_side`.
void corner(int side, std::size_t ring, float normal_side) {
  const std::size_t below = ring > 0 ? ring - 1 : 0, above = std::min(ring + 1, radii.size() - 1);
  const float slope = (radii[below] - radii[above]) / (0.5F * static_cast<float>(above - below));
  const float turn = -6.2831853F * static_cast<float>(side % sides) / sides;
  const float normal_turn = -6.2831853F * std::fmod(normal_side, sides) / sides;
  glNormal3f(std::cos(normal_turn), slope, std::sin(normal_turn));
  glVertex3f(radii[ring] * std::cos(turn), 0.5F * static_cast<float>(ring) - 1, radii[ring] * std::sin(turn));
}

// [side]
void draw_side(int side) {
  const auto here = static_cast<float>(side);
  const float left = here + 0.5F, right = here + 0.5F;  // TODO: normals of the middle of the side make it flat
  for (std::size_t ring = 0; ring + 1 < radii.size(); ++ring) {
    corner(side, ring, left);
    corner(side + 1, ring, right);
    corner(side + 1, ring + 1, right);
    corner(side, ring + 1, left);
  }
}
// [/side]

void draw(double) {
  lesson::look(4, 10, 20);
  lesson::light();
  glColor3f(0.7F, 0.7F, 0.75F);
  glBegin(GL_QUADS);
  for (int side = 0; side < sides; ++side) draw_side(side);
  glEnd();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 10, exercise 3: a tower", .keys = {}, .begin = {}, .draw = draw});
}
