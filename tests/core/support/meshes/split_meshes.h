// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Closed meshes whose vertices are split: hard edges, seams, and other features of real files.
#pragma once

#include <cmath>
#include <random>

#include "tests/core/support/curved_program.h"
#include "tests/core/support/meshes/closed_mesh.h"

namespace glark::core::test {

using Vector = std::array<GLfloat, 3>;

inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector unit(const Vector& v) {
  const GLfloat length = std::hypot(v[0], v[1], v[2]);
  return length > 0 ? Vector{v[0] / length, v[1] / length, v[2] / length} : v;
}

inline Vector face_normal(const Mesh& mesh, const std::array<std::size_t, 3>& t) {
  const Vector& p = mesh.positions[t[0]];
  return unit(cross(minus(mesh.positions[t[1]], p), minus(mesh.positions[t[2]], p)));
}

// A triangle soup: every triangle has its own vertices. Tags are 0.
class SplitMesh {
 public:
  std::vector<CurvedVertex> vertices;

  std::size_t triangles() const { return vertices.size() / 3; }

  void add(const std::array<Vector, 3>& positions, const std::array<Vector, 3>& normals) {
    const auto number = static_cast<GLfloat>(triangles());
    for (std::size_t k = 0; k < 3; ++k) {
      CurvedVertex vertex{positions[k], normals[k], {}, number, 0};
      vertex.weights[k] = 1;
      vertices.push_back(vertex);
    }
  }
  // Equal positions get equal tags, up to `level`.
  SplitMesh tagged_at_random(unsigned level, unsigned seed) const {
    SplitMesh result = *this;
    for (CurvedVertex& vertex : result.vertices) {
      std::uint32_t hash = seed * 2654435761U + 12345;
      for (const GLfloat value : vertex.position) {
        std::uint32_t bits = 0;
        const GLfloat positive_zero = value + 0.0F;
        std::memcpy(&bits, &positive_zero, sizeof(bits));
        hash = (hash ^ bits) * 2246822519U;
        hash ^= hash >> 15;
      }
      vertex.tag = static_cast<GLubyte>(hash % (level + 1));
    }
    return result;
  }
};

inline SplitMesh flat_shaded(const Mesh& mesh) {
  SplitMesh result;
  for (const auto& t : mesh.triangles) {
    const Vector normal = face_normal(mesh, t);
    result.add({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, {normal, normal, normal});
  }
  return result;
}

// Normals of the vertices, each turned at random in each triangle: every edge is a seam.
inline SplitMesh seams_everywhere(const Mesh& mesh, GLfloat strength, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vector> normals(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    const Vector normal = face_normal(mesh, t);
    for (const std::size_t corner : t) {
      for (std::size_t i = 0; i < 3; ++i) normals[corner][i] += normal[i];
    }
  }
  SplitMesh result;
  for (const auto& t : mesh.triangles) {
    std::array<Vector, 3> turned;
    for (std::size_t k = 0; k < 3; ++k) {
      turned[k] = unit(normals[t[k]]);
      for (GLfloat& value : turned[k]) value += strength * (static_cast<GLfloat>(random() % 2001) / 1000 - 1);
    }
    result.add({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, turned);
  }
  return result;
}

// A smooth mesh, with hard edges where faces differ by more than the angle of that cosine.
inline SplitMesh creased(const Mesh& mesh, GLfloat cosine) {
  std::vector<std::vector<Vector>> about(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    for (const std::size_t corner : t) about[corner].push_back(face_normal(mesh, t));
  }
  SplitMesh result;
  for (const auto& t : mesh.triangles) {
    const Vector own = face_normal(mesh, t);
    std::array<Vector, 3> normals{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (const Vector& n : about[t[k]]) {
        if (n[0] * own[0] + n[1] * own[1] + n[2] * own[2] < cosine) continue;
        for (std::size_t i = 0; i < 3; ++i) normals[k][i] += n[i];
      }
      normals[k] = unit(normals[k]);
    }
    result.add({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, normals);
  }
  return result;
}

inline Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.push_back({(i & 1) != 0 ? 1.0F : -1.0F, (i & 2) != 0 ? 1.0F : -1.0F, (i & 4) != 0 ? 1.0F : -1.0F});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// Two rings about the z axis, with lids of flat normals. If `depth` is not 0, the second ring has other radii at every
// other pair of vertices. If `smooth`, the wall is smooth.
inline SplitMesh gear(int teeth, GLfloat depth, bool smooth) {
  const int sides = 4 * teeth;
  const auto point = [&](int k, GLfloat z) {
    const GLfloat angle = 6.2831853F * static_cast<GLfloat>(k % sides) / static_cast<GLfloat>(sides);
    const GLfloat radius = (k % 4) < 2 ? 1.5F : 1.5F - depth;
    return Vector{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  const auto outwards = [](const Vector& p) { return unit({p[0], p[1], 0}); };
  SplitMesh mesh;
  for (int k = 0; k < sides; ++k) {
    const std::array<Vector, 4> wall = {point(k, -0.5F), point(k + 1, -0.5F), point(k + 1, 0.5F), point(k, 0.5F)};
    const Vector flat = unit(cross(minus(wall[1], wall[0]), minus(wall[3], wall[0])));
    const auto normal = [&](std::size_t i) { return smooth ? outwards(wall[i]) : flat; };
    mesh.add({wall[0], wall[1], wall[2]}, {normal(0), normal(1), normal(2)});
    mesh.add({wall[0], wall[2], wall[3]}, {normal(0), normal(2), normal(3)});
    const Vector up{0, 0, 1};
    const Vector down{0, 0, -1};
    mesh.add({wall[3], wall[2], {0, 0, 0.5F}}, {up, up, up});
    mesh.add({wall[1], wall[0], {0, 0, -0.5F}}, {down, down, down});
  }
  return mesh;
}

}  // namespace glark::core::test
