// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Surfaces to sample, closed and with known normals.
#pragma once

#include <glark/vstree.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::vstree::test {

struct Shape {
  std::vector<float> positions, normals, texcoords;
  std::vector<std::uint8_t> colours;
  std::vector<std::uint32_t> triangles;

  PointSet points() const { return {.positions = positions, .normals = normals}; }
  Mesh mesh() const { return {points(), triangles}; }
  std::size_t size() const { return positions.size() / 3; }
  std::array<float, 3> position(std::size_t i) const {
    return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
  }
};

// Makes n times n vertices around a torus of radii 1 and 0.4. The torus is a little bumpy, and tilted, so that it is
// parallel to no axis.
inline Shape torus(std::uint32_t n, float bumps = 0.02F) {
  Shape shape;
  const float step = 2 * 3.14159265F / static_cast<float>(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const float u = step * static_cast<float>(i), v = step * static_cast<float>(k);
      const float r = 0.4F + bumps * std::sin(5 * u) * std::sin(4 * v);
      const float x = (1 + r * std::cos(v)) * std::cos(u), y = (1 + r * std::cos(v)) * std::sin(u), z = r * std::sin(v);
      const float nx = std::cos(v) * std::cos(u), ny = std::cos(v) * std::sin(u), nz = std::sin(v);
      shape.positions.insert(shape.positions.end(), {x, 0.8F * y - 0.6F * z, 0.6F * y + 0.8F * z});
      shape.normals.insert(shape.normals.end(), {nx, 0.8F * ny - 0.6F * nz, 0.6F * ny + 0.8F * nz});
      const std::uint32_t a = i * n + k, b = (i + 1) % n * n + k;
      const std::uint32_t c = (i + 1) % n * n + (k + 1) % n, d = i * n + (k + 1) % n;
      shape.triangles.insert(shape.triangles.end(), {a, b, c, a, c, d});
    }
  }
  return shape;
}

// Tori within one another, nearer than the clusters are wide.
inline Shape nested_tori(std::uint32_t n) {
  Shape shape = torus(n, 0);
  const Shape one = shape;
  for (const float scale : {0.985F, 0.97F}) {
    const auto first = static_cast<std::uint32_t>(shape.size());
    for (const std::uint32_t i : one.triangles) shape.triangles.push_back(first + i);
    for (const float number : one.positions) shape.positions.push_back(scale * number);
  }
  return shape;
}

// Random samples of the unit sphere.
inline Shape sphere(std::size_t count, float noise = 0) {
  Shape shape;
  std::mt19937 random(7);
  const auto number = [&] { return static_cast<float>(random()) / 2147483648.0F - 1; };
  while (shape.size() < count) {
    const float x = number(), y = number(), z = number();
    const float size = std::hypot(x, y, z);
    if (size > 1 || size < 0.1F) continue;
    const float out = (1 + noise * number()) / size;
    shape.positions.insert(shape.positions.end(), {x * out, y * out, z * out});
    shape.normals.insert(shape.normals.end(), {x / size, y / size, z / size});
  }
  return shape;
}

// Edges with more than two triangles, and with one.
struct EdgeFaults {
  std::size_t non_manifold = 0, boundary = 0;
};
inline EdgeFaults edge_faults(const std::vector<std::uint32_t>& triangles) {
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    edges.insert(std::minmax<std::uint32_t>({triangles[i], triangles[i % 3 == 2 ? i - 2 : i + 1]}));
  EdgeFaults faults;
  for (auto edge = edges.begin(); edge != edges.end(); edge = edges.upper_bound(*edge)) {
    faults.non_manifold += edges.count(*edge) > 2 ? 1 : 0;
    faults.boundary += edges.count(*edge) == 1 ? 1 : 0;
  }
  return faults;
}

// The number of parts of triangles that share vertices.
template <typename Triangles>
std::size_t parts_of(const Triangles& mesh) {
  common::DisjointSets sets(mesh.positions.size() / 3);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    sets.join(mesh.triangles[t], mesh.triangles[t + 1]);
    sets.join(mesh.triangles[t], mesh.triangles[t + 2]);
  }
  std::set<std::uint32_t> parts;
  for (const std::uint32_t vertex : mesh.triangles) parts.insert(sets.find(vertex));
  return parts.size();
}

}  // namespace glark::vstree::test
