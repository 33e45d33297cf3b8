// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lesson 6: curved triangles. An octahedron becomes a ball, because a curved PN triangle bends until it meets the
// normals of its corners. A column shows how normals decide what is round and what is sharp.
#include <GL/gl.h>

#include <GL/glark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "examples/common/lesson.h"
#include "examples/common/look.h"

namespace {

using Vector = std::array<float, 3>;
using Triangle = std::array<Vector, 3>;

constexpr unsigned deepest = 5;
unsigned depth = 4;
float crease_degrees = 180;
GLint shape = GL_CURVED_PN_ARK;
bool column = false, weld = false, wireframe = false;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
float dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector face_normal(const Triangle& t) {
  const Vector ab = {t[1][0] - t[0][0], t[1][1] - t[0][1], t[1][2] - t[0][2]};
  const Vector ac = {t[2][0] - t[0][0], t[2][1] - t[0][1], t[2][2] - t[0][2]};
  const Vector n = cross(ab, ac);
  const float size = std::sqrt(dot(n, n));
  return {n[0] / size, n[1] / size, n[2] / size};
}

// [normal]
// The normal of a corner: the mean of the faces at the same point that turn away from its own face by at most
// crease_degrees.
Vector corner_normal(const std::vector<Triangle>& mesh, const Triangle& own, const Vector& point) {
  const Vector n = face_normal(own);
  const float least_cosine = std::cos(crease_degrees * 3.1415927F / 180) - 1e-4F;
  Vector sum{};
  for (const Triangle& other : mesh) {
    const bool meets = other[0] == point || other[1] == point || other[2] == point;
    const Vector m = face_normal(other);
    if (!meets || dot(n, m) < least_cosine) continue;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += m[k];
  }
  return sum;
}
// [/normal]

std::vector<Triangle> octahedron() {
  std::vector<Triangle> mesh;
  for (const float z : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float x : {-1.0F, 1.0F}) {
        const Vector a = {x, 0, 0}, b = {0, y, 0}, c = {0, 0, z};
        mesh.push_back(x * y * z > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
      }
    }
  }
  return mesh;
}

// An eight-sided column. Neighbouring walls meet at 45 degrees, walls and lids at 90 degrees.
std::vector<Triangle> column_mesh() {
  constexpr int sides = 8;
  const auto at = [](int side, float y) {
    const float turn = -6.2831853F * static_cast<float>(side % sides) / sides;
    return Vector{0.75F * std::cos(turn), y, 0.75F * std::sin(turn)};
  };
  std::vector<Triangle> mesh;
  for (int i = 0; i < sides; ++i) {
    mesh.push_back({at(i, -0.9F), at(i + 1, -0.9F), at(i + 1, 0.9F)});
    mesh.push_back({at(i, -0.9F), at(i + 1, 0.9F), at(i, 0.9F)});
    mesh.push_back({Vector{0, 0.9F, 0}, at(i, 0.9F), at(i + 1, 0.9F)});
    mesh.push_back({Vector{0, -0.9F, 0}, at(i + 1, -0.9F), at(i, -0.9F)});
  }
  return mesh;
}

void draw_mesh(const std::vector<Triangle>& mesh) {
  glDepthTag1i(depth);
  glBegin(GL_TRIANGLES);
  for (const Triangle& triangle : mesh) {
    for (const Vector& point : triangle) {
      glNormal3fv(corner_normal(mesh, triangle, point).data());
      glVertex3fv(point.data());
    }
  }
  glEnd();
}

// [draw]
void draw(double) {
  glARKParameteriARK(GL_REFINEMENT_ARK, shape);  // where the refined vertices lie
  glARKParameteriARK(GL_WELD_ARK, weld ? GL_TRUE : GL_FALSE);
  lesson::look(3.6F, 30, 25);
  lesson::light();
  glColor3f(0.95F, 0.6F, 0.2F);
  const auto mesh = [] { draw_mesh(column ? column_mesh() : octahedron()); };
  if (wireframe) lesson::draw_with_edges(mesh);
  if (!wireframe) mesh();
  const char* const form = shape == GL_CURVED_PN_ARK ? "PN" : shape == GL_PHONG_ARK ? "Phong" : "linear";
  lesson::say("%s, depth %u, sharp from %g degrees on%s", form, depth, crease_degrees, weld ? ", welded" : "");
}
// [/draw]

void begin() {
  glARKinit(deepest);
  glEnable(GL_ARK);
}

void next_shape() {
  shape = shape == GL_LINEAR_INPUTS_ARK ? GL_PHONG_ARK
          : shape == GL_PHONG_ARK       ? GL_CURVED_PN_ARK
                                        : GL_LINEAR_INPUTS_ARK;
}

}  // namespace

int main(int argc, char** argv) {
  return lesson::run(
      argc, argv,
      {.title = "Lesson 6: curved triangles",
       .keys = {{'d', "one level deeper", [] { depth = std::min(depth + 1, deepest); }},
                {'s', "one level shallower", [] { depth -= depth > 0 ? 1 : 0; }},
                {'f', "next shape: linear, Phong, PN", next_shape},
                {'m', "octahedron or column", [] { column = !column; }},
                {'a', "sharp from 0, 60 or 180 degrees on",
                 [] { crease_degrees = crease_degrees == 0    ? 60.0F
                                       : crease_degrees == 60 ? 180.0F
                                                              : 0; }},
                {'e', "weld: edges of both sides meet", [] { weld = !weld; }},
                {'w', "wireframe", [] { wireframe = !wireframe; }}},
       .begin = begin,
       .draw = draw});
}
