// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 2 of lesson 10: a surface through points. The program draws the points of a ring. Make strips
// of them and draw the strips instead; begin() has prepared curved triangles already.
#include <GL/gl.h>

#include <GL/glark.h>
#include <glark/surfel.h>

#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

constexpr int scanned = 4000;

struct Scan {
  std::vector<float> positions, normals;
};

// Points around a ring with a wave, in no order.
Scan make_scan() {
  Scan scan;
  for (int i = 0; i < scanned; ++i) {
    const float along = 6.2831853F * std::fmod(static_cast<float>(i) * 0.7548777F, 1.0F);
    const float around = 6.2831853F * std::fmod(static_cast<float>(i) * 0.5698403F, 1.0F);
    const float radius = 1 + 0.35F * std::cos(around), x = std::cos(along), z = std::sin(along);
    scan.positions.insert(scan.positions.end(), {radius * x, 0.35F * std::sin(around), radius * z});
    scan.normals.insert(scan.normals.end(), {std::cos(around) * x, std::sin(around), std::cos(around) * z});
  }
  return scan;
}

void begin() {
  glARKinit(3);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY}) glEnableClientState(array);
}

void draw(double) {
  static const Scan scan = make_scan();
  lesson::look(3.6F, 0, 40);
  lesson::light();
  glColor3f(0.35F, 0.6F, 0.75F);
  glVertexPointer(3, GL_FLOAT, 0, scan.positions.data());
  glNormalPointer(GL_FLOAT, 0, scan.normals.data());
  glDrawArrays(GL_POINTS, 0, scanned);  // TODO: strips
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv, {.title = "Lesson 10, exercise 2: points", .keys = {}, .begin = begin, .draw = draw});
}
