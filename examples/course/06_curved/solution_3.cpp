// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Exercise 3 of lesson 6: hard edges by angle. A cut stone is rounded everywhere. Faces that meet at more than 60
// degrees should keep a hard edge.
#include <GL/gl.h>

#include <GL/glark.h>

#include <array>
#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

using Vector = std::array<float, 3>;
using Triangle = std::array<Vector, 3>;

// The cut stone of a ring: a girdle of eight corners, a flat table above, a point below.
std::vector<Triangle> stone() {
  const auto at = [](int i, float radius, float y) {
    const float turn = -6.2831853F * static_cast<float>(i % 8) / 8;
    return Vector{radius * std::cos(turn), y, radius * std::sin(turn)};
  };
  std::vector<Triangle> mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.push_back({at(i, 1, 0.2F), at(i + 1, 1, 0.2F), at(i + 1, 0.65F, 0.5F)});
    mesh.push_back({at(i, 1, 0.2F), at(i + 1, 0.65F, 0.5F), at(i, 0.65F, 0.5F)});
    mesh.push_back({Vector{0, 0.5F, 0}, at(i, 0.65F, 0.5F), at(i + 1, 0.65F, 0.5F)});
    mesh.push_back({Vector{0, -0.8F, 0}, at(i + 1, 1, 0.2F), at(i, 1, 0.2F)});
  }
  return mesh;
}

Vector face_normal(const Triangle& t) {
  const Vector a = {t[1][0] - t[0][0], t[1][1] - t[0][1], t[1][2] - t[0][2]};
  const Vector b = {t[2][0] - t[0][0], t[2][1] - t[0][1], t[2][2] - t[0][2]};
  const Vector n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const float size = std::hypot(n[0], n[1], n[2]);
  return {n[0] / size, n[1] / size, n[2] / size};
}

float cosine(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector corner_normal(const std::vector<Triangle>& mesh, const Triangle& own, const Vector& point) {
  Vector sum{};
  for (const Triangle& other : mesh) {
    if (other[0] != point && other[1] != point && other[2] != point) continue;
    if (cosine(face_normal(own), face_normal(other)) < 0.5F) continue;  // the cosine of 60 degrees
    const Vector n = face_normal(other);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
  }
  return sum;
}

void begin() {
  glARKinit(5);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_WELD_ARK, GL_TRUE);
}

void draw(double) {
  static const std::vector<Triangle> mesh = stone();
  lesson::look(3.2F, 15, 25);
  lesson::light();
  glColor3f(0.55F, 0.8F, 0.75F);
  glDepthTag1i(5);
  glBegin(GL_TRIANGLES);
  for (const Triangle& triangle : mesh) {
    for (const Vector& point : triangle) {
      glNormal3fv(corner_normal(mesh, triangle, point).data());
      glVertex3fv(point.data());
    }
  }
  glEnd();
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(argc, argv,
                     {.title = "Lesson 6, exercise 3: hard edges", .keys = {}, .begin = begin, .draw = draw});
}
