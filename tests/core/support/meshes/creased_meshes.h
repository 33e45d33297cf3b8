// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Meshes with the mean normals of their faces at each vertex, as many programs make them: smooth ones, and some that
// should not be smooth.
#pragma once

#include "tests/core/support/meshes/split_meshes.h"

namespace glark::core::test {

inline SplitMesh averaged(const Mesh& mesh) { return seams_everywhere(mesh, 0, 1); }

inline Mesh octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// Copies side by side.
inline SplitMesh rows_of(const SplitMesh& mesh, int copies) {
  SplitMesh result;
  for (int copy = 0; copy < copies; ++copy) {
    for (CurvedVertex vertex : mesh.vertices) {
      vertex.position[0] += 3 * static_cast<GLfloat>(copy);
      result.vertices.push_back(vertex);
    }
  }
  return result;
}

inline std::array<Vector, 3> positions_of(const SplitMesh& mesh, std::size_t t, std::size_t first = 0) {
  const auto at = [&](std::size_t k) { return mesh.vertices[3 * t + (first + k) % 3].position; };
  return {at(0), at(1), at(2)};
}

inline std::array<Vector, 3> normals_of(const SplitMesh& mesh, std::size_t t, std::size_t first = 0) {
  const auto at = [&](std::size_t k) { return mesh.vertices[3 * t + (first + k) % 3].normal; };
  return {at(0), at(1), at(2)};
}

// Every triangle once more from behind, with the opposite normals.
inline SplitMesh with_backs(const SplitMesh& mesh) {
  SplitMesh result = mesh;
  for (std::size_t t = 0; t < mesh.triangles(); ++t) {
    const auto p = positions_of(mesh, t);
    auto n = normals_of(mesh, t);
    for (Vector& normal : n) normal = {-normal[0], -normal[1], -normal[2]};
    result.add({p[1], p[0], p[2]}, {n[1], n[0], n[2]});
  }
  return result;
}

// A surface of revolution about the z axis, from radii and heights. A radius of 0 is one vertex.
struct Ring {
  GLfloat radius = 0;
  GLfloat height = 0;
};
inline Mesh turned(const std::vector<Ring>& rings, int slices) {
  Mesh mesh;
  const auto n = static_cast<std::size_t>(slices);
  for (const Ring& ring : rings) {
    for (std::size_t k = 0; k < n; ++k) {
      const GLfloat angle = 6.2831853F * static_cast<GLfloat>(k) / static_cast<GLfloat>(slices);
      mesh.positions.push_back({ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.height});
    }
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::size_t k = 0; k < n; ++k) {
      const auto at = [&](std::size_t row, std::size_t slice) {
        return row * n + (rings[row].radius == 0 ? 0 : slice % n);
      };
      if (rings[r].radius != 0) mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k)});
      if (rings[r + 1].radius != 0) mesh.triangles.push_back({at(r, k + 1), at(r + 1, k + 1), at(r + 1, k)});
    }
  }
  return mesh;
}

// A unit sphere with its own normals.
inline SplitMesh sphere(int slices, int stacks) {
  std::vector<Ring> rings;
  for (int i = 0; i <= stacks; ++i) {
    const GLfloat angle = 3.14159265F * static_cast<GLfloat>(i) / static_cast<GLfloat>(stacks);
    rings.push_back({i == 0 || i == stacks ? 0 : std::sin(angle), -std::cos(angle)});
  }
  SplitMesh mesh = averaged(turned(rings, slices));
  for (CurvedVertex& vertex : mesh.vertices) vertex.normal = unit(vertex.position);
  return mesh;
}

inline SplitMesh torus(int rings, int sides, GLfloat tube) {
  Mesh mesh;
  const auto n = static_cast<std::size_t>(rings);
  const auto m = static_cast<std::size_t>(sides);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      const GLfloat a = 6.2831853F * static_cast<GLfloat>(i) / static_cast<GLfloat>(n);
      const GLfloat b = 6.2831853F * static_cast<GLfloat>(k) / static_cast<GLfloat>(m);
      const GLfloat r = 1 + tube * std::cos(b);
      mesh.positions.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
      const std::size_t next = (i + 1) % n;
      mesh.triangles.push_back({i * m + k, next * m + k, next * m + (k + 1) % m});
      mesh.triangles.push_back({i * m + k, next * m + (k + 1) % m, i * m + (k + 1) % m});
    }
  }
  return averaged(mesh);
}

// A prism with lids, of radius 1, whose normals are averaged over its sides and lids.
inline SplitMesh pole(int sides, GLfloat length) {
  return averaged(turned({{0, 0}, {1, 0}, {1, length}, {0, length}}, sides));
}

// Its lids have slopes of 45 degrees.
inline SplitMesh chamfered_pole(int sides, GLfloat length) {
  return averaged(
      turned({{0, -0.5F}, {0.5F, -0.5F}, {1, 0}, {1, length}, {0.5F, length + 0.5F}, {0, length + 0.5F}}, sides));
}

// A pointed pole without a lid. The first corner of the first triangles is at the bottom.
inline SplitMesh antenna(int sides, GLfloat length) { return averaged(turned({{1, 0}, {0, length}}, sides)); }

// Triangles of the given width about a common vertex, with the normals of a ball.
inline SplitMesh sliver_fan(int count, GLfloat width) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (int i = 0; i <= count; ++i) {
    const GLfloat angle = width * static_cast<GLfloat>(i);
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.1F * static_cast<GLfloat>(i % 2)});
    if (i > 0) mesh.triangles.push_back({0, static_cast<std::size_t>(i), static_cast<std::size_t>(i) + 1});
  }
  SplitMesh result = averaged(mesh);
  for (CurvedVertex& vertex : result.vertices) vertex.normal = unit(vertex.position);
  return result;
}

// Two triangles that meet at a gentle angle, with open borders.
inline SplitMesh bent_leaf() {
  SplitMesh mesh;
  const Vector a{0, -1, 0};
  const Vector b{0, 1, 0};
  const Vector na{0, -0.4F, 1};
  const Vector nb{0, 0.4F, 1};
  mesh.add({a, b, {-1, 0, -0.2F}}, {na, nb, Vector{-0.4F, 0, 1}});
  mesh.add({b, a, {1, 0, -0.2F}}, {nb, na, Vector{0.4F, 0, 1}});
  return mesh;
}

// A row of quads about the z axis, as one strip of a program that draws ring by ring. `angles`: of the lower and the
// upper ring of a unit sphere, from its equator; the normals are those of the sphere.
inline SplitMesh zone_of_sphere(int sides, float low, float high) {
  SplitMesh mesh;
  const auto at = [&](int side, float angle) {
    const float turn = 2 * 3.14159265F * static_cast<float>(side % sides) / static_cast<float>(sides);
    return Vector{std::cos(turn) * std::cos(angle), std::sin(turn) * std::cos(angle), std::sin(angle)};
  };
  for (int side = 0; side < sides; ++side) {
    const Vector a = at(side, low), b = at(side + 1, low), c = at(side + 1, high), d = at(side, high);
    mesh.add({a, b, c}, {a, b, c});
    mesh.add({a, c, d}, {a, c, d});
  }
  return mesh;
}

// A ring of a shallow dish whose normals are its positions. They lean by 60 degrees, and turn as the ring does.
inline SplitMesh leaning_ring() {
  constexpr int sides = 72;
  const auto at = [](int side, float radius, float z) {
    const float turn = 2 * 3.14159265F * static_cast<float>(side % sides) / sides;
    return Vector{radius * std::cos(turn), radius * std::sin(turn), z};
  };
  SplitMesh ring;
  for (int side = 0; side < sides; ++side) {
    const Vector a = at(side, 0.8F, 0.142F), b = at(side + 1, 0.8F, 0.142F), c = at(side + 1, 0.7F, 0.167F);
    const Vector d = at(side, 0.7F, 0.167F);
    ring.add({a, b, c}, {a, b, c});
    ring.add({a, c, d}, {a, c, d});
  }
  return ring;
}

// The wall of a cone's frustum without lids. `top`: its upper radius; the lower one is 1, as the height.
inline SplitMesh wall(int sides, float top) {
  SplitMesh mesh;
  const auto on = [&](int side, float radius, float z) {
    const float turn = 2 * 3.14159265F * static_cast<float>(side % sides) / static_cast<float>(sides);
    return Vector{radius * std::cos(turn), radius * std::sin(turn), z};
  };
  for (int side = 0; side < sides; ++side) {
    const Vector a = on(side, 1, 0), b = on(side + 1, 1, 0), c = on(side + 1, top, 1), d = on(side, top, 1);
    const Vector n = on(side, 1, 1 - top), m = on(side + 1, 1, 1 - top);
    mesh.add({a, b, c}, {n, m, m});
    mesh.add({a, c, d}, {n, m, n});
  }
  return mesh;
}

}  // namespace glark::core::test
