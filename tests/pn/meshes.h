// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace glark::pn::test {

struct IndexedMesh {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
  std::uint32_t add(float x, float y, float z) {
    positions.insert(positions.end(), {x, y, z});
    return static_cast<std::uint32_t>(positions.size() / 3 - 1);
  }
  void face(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles.insert(triangles.end(), {a, b, c}); }
};

inline IndexedMesh cube() {
  IndexedMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const auto side = [i](int bit) { return (i & bit) != 0 ? 1.0F : -1.0F; };
    mesh.add(side(1), side(2), side(4));
  }
  mesh.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

// Makes a cylinder about the z axis, from z = -1 to 1. The caps are fans around their middles, or around a vertex of
// their boundary.
inline IndexedMesh cylinder(std::uint32_t sides, bool with_middles) {
  IndexedMesh mesh;
  for (const float z : {-1.0F, 1.0F}) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double turn = 2 * M_PI * i / sides;
      mesh.add(static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), z);
    }
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    mesh.face(i, next, sides + next);
    mesh.face(i, sides + next, sides + i);
  }
  const std::uint32_t bottom = with_middles ? mesh.add(0, 0, -1) : 0;
  const std::uint32_t top = with_middles ? mesh.add(0, 0, 1) : sides;
  for (std::uint32_t i = with_middles ? 0 : 1; i < (with_middles ? sides : sides - 1); ++i) {
    const std::uint32_t next = (i + 1) % sides;
    mesh.face(bottom, next, i);
    mesh.face(top, sides + i, sides + next);
  }
  return mesh;
}

// Gives every triangle its own vertices and the normal of its plane, as programs with flat shading do.
inline IndexedMesh unshared(const IndexedMesh& mesh, std::vector<float>& normals) {
  IndexedMesh result;
  normals.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    double p[3][3];
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) p[k][axis] = mesh.positions[3 * mesh.triangles[t + k] + axis];
      result.triangles.push_back(
          result.add(static_cast<float>(p[k][0]), static_cast<float>(p[k][1]), static_cast<float>(p[k][2])));
    }
    double n[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3;
      const std::size_t z = (axis + 2) % 3;
      n[axis] = (p[1][y] - p[0][y]) * (p[2][z] - p[0][z]) - (p[1][z] - p[0][z]) * (p[2][y] - p[0][y]);
    }
    for (int k = 0; k < 3; ++k) {
      for (const double x : n) normals.push_back(static_cast<float>(x));
    }
  }
  return result;
}

}  // namespace glark::pn::test
