// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The topology of a mesh.
#pragma once

#include <glark/reconstruct.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "tests/vstree/shapes.h"

namespace glark::reconstruct::test {

using namespace vstree;
using namespace vstree::test;

struct Topology {
  std::size_t boundary = 0;  // the number of edges of one triangle
  std::size_t wrong = 0;     // the number of edges with more than two triangles, or with two of different orientation
  // The number of fans of triangles around vertices; if each vertex has one fan, the number of vertices.
  std::size_t fans = 0;
  std::size_t parts = 0;
  std::ptrdiff_t euler = 0;  // vertices - edges + triangles
};

inline Topology topology_of(const Reconstructed& mesh) {
  std::vector<std::uint32_t> part(mesh.positions.size() / 3), fan(mesh.triangles.size());
  std::iota(part.begin(), part.end(), 0U);
  std::iota(fan.begin(), fan.end(), 0U);
  const auto root = [](std::vector<std::uint32_t>& sets, std::uint32_t i) {
    while (sets[i] != i) i = sets[i] = sets[sets[i]];
    return i;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
  const auto next = [](std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; };
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t a = mesh.triangles[i], b = mesh.triangles[next(i)];
    edges[std::minmax(a, b)].push_back(i);
    part[root(part, a)] = root(part, b);
  }
  Topology topology;
  for (const auto& [edge, corners] : edges) {
    topology.boundary += corners.size() == 1 ? 1 : 0;
    if (corners.size() < 2) continue;
    const std::uint32_t a = corners[0], b = corners[1];
    topology.wrong += corners.size() > 2 || mesh.triangles[a] == mesh.triangles[b] ? 1 : 0;
    fan[root(fan, a)] = root(fan, next(b));
    fan[root(fan, next(a))] = root(fan, b);
  }
  for (std::uint32_t i = 0; i < fan.size(); ++i) topology.fans += fan[i] == i ? 1 : 0;
  for (std::uint32_t i = 0; i < part.size(); ++i) topology.parts += part[i] == i ? 1 : 0;
  topology.euler =
      static_cast<std::ptrdiff_t>(part.size() + mesh.triangles.size() / 3) - static_cast<std::ptrdiff_t>(edges.size());
  return topology;
}

// Expects a manifold with the connectivity of subdivision, where all vertices have triangles.
inline void expect_manifold(const Reconstructed& mesh) {
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.wrong, 0U);
  EXPECT_EQ(topology.fans, mesh.positions.size() / 3);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.triangles.size() / 3, mesh.base_triangles * (std::size_t{1} << (2 * mesh.levels)));
  for (const float number : mesh.positions) ASSERT_TRUE(std::isfinite(number));
  for (std::size_t i = 0; i < mesh.normals.size(); i += 3)
    ASSERT_NEAR(std::hypot(mesh.normals[i], mesh.normals[i + 1], mesh.normals[i + 2]), 1, 1e-3);
}

inline void expect_closed(const Reconstructed& mesh, std::size_t parts, std::ptrdiff_t euler) {
  expect_manifold(mesh);
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.boundary, 0U);
  EXPECT_EQ(topology.parts, parts);
  EXPECT_EQ(topology.euler, euler);
}

// Returns the greatest distance(vertex).
template <typename Distance>
double greatest(const Reconstructed& mesh, const Distance& distance) {
  double most = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    most = std::max(
        most, std::abs(static_cast<double>(distance(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]))));
  }
  return most;
}

// Returns six times the volume. It is positive if the triangles face outwards.
inline double volume(const Reconstructed& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const auto at = [&](std::size_t i, std::size_t k) {
      return static_cast<double>(mesh.positions[3 * std::size_t{mesh.triangles[t + i]} + k]);
    };
    for (std::size_t k = 0; k < 3; ++k)
      sum += at(0, k) * (at(1, (k + 1) % 3) * at(2, (k + 2) % 3) - at(1, (k + 2) % 3) * at(2, (k + 1) % 3)) / 6;
  }
  return sum;
}

}  // namespace glark::reconstruct::test
