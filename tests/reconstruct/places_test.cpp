// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The edges of a mesh whose vertices at one position count as one.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "glark/clients/reconstruct/result/places.h"
#include "tests/reconstruct/meshes.h"

namespace glark::reconstruct::test {
namespace {

TEST(Places, CountsEdges) {
  const std::vector<float> positions{0, 0, 0, 3, 0, 0, 0, 4, 0, 3, 4, 0, -0.0F, 0, 0, 3, 0, 0, 0, 0, 5};
  const EdgeCounts one = count_edges(positions, std::vector<std::uint32_t>{0, 1, 2});
  EXPECT_EQ(3U, one.boundary);
  EXPECT_DOUBLE_EQ(12, one.boundary_length);
  EXPECT_EQ(0U, one.non_manifold);
  const EdgeCounts two = count_edges(positions, std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2});
  EXPECT_EQ(4U, two.boundary);
  EXPECT_DOUBLE_EQ(14, two.boundary_length);
  // The third triangle has other vertices at the places of the first edge.
  const EdgeCounts book = count_edges(positions, std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3, 5, 4, 6});
  EXPECT_EQ(1U, book.non_manifold);
  EXPECT_EQ(6U, book.boundary);
}

// Two tetrahedra that share an edge by position.
TEST(Places, TouchingSheetsArePartedByALittle) {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, -1};
  const std::vector<std::uint32_t> triangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 4, 6, 5, 4, 5, 7, 5, 6, 7, 4, 7, 6};
  const std::vector<float> normals(positions.size(), 0.577F), before = positions;
  ASSERT_EQ(1U, count_edges(positions, triangles).non_manifold);
  part_places(positions, normals, triangles);
  EXPECT_EQ(0U, count_edges(positions, triangles).non_manifold);
  EXPECT_EQ(0U, count_edges(positions, triangles).boundary);
  for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_NEAR(before[i], positions[i], 0.03);
}

// Four triangles at one edge, by indices. Two sheets get vertices of their own.
TEST(Places, SheetsAreCutAtAnEdge) {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0.1F, 0, -1, 0.1F, 0, 1, -0.1F, 0, -1, -0.1F};
  std::vector<std::uint32_t> triangles{0, 1, 2, 1, 0, 3, 1, 0, 4, 0, 1, 5};
  ASSERT_EQ(1U, count_edges(positions, triangles).non_manifold);
  const std::vector<std::uint32_t> originals = cut_at_edges(positions, triangles);
  ASSERT_EQ(8U, originals.size());
  for (std::size_t i = 6; i < 8; ++i) {
    for (std::size_t k = 0; k < 3; ++k) positions.push_back(positions[3 * std::size_t{originals[i]} + k]);
  }
  part_places(positions, std::vector<float>(24, 0), triangles);
  EXPECT_EQ(0U, count_edges(positions, triangles).non_manifold);
  EXPECT_EQ(8U, count_edges(positions, triangles).boundary);
}

TEST(Places, MeshesWithoutSuchEdgesStayAsTheyAre) {
  std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, -1, 0};
  const std::vector<float> before = positions, normals(18, 0);
  part_places(positions, normals, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  EXPECT_EQ(before, positions);
}

// A hollow box of random points, `width` thick, within the unit cube.
Shape hollow_box(double width, std::size_t count, unsigned seed) {
  Shape shape;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const bool inner = i % 2 == 1;
    const double half = inner ? 0.5 - width : 0.5;
    const std::size_t axis = i / 2 % 3;
    const double side = i / 6 % 2 == 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      shape.positions.push_back(static_cast<float>(k == axis ? side * half : half * (2 * uniform(random) - 1)));
      shape.normals.push_back(static_cast<float>(k == axis ? (inner ? -side : side) : 0));
    }
  }
  return shape;
}

TEST(Places, ThinWallsAreManifoldByPosition) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    for (const double width : {0.01, 0.02}) {
      const Reconstructed mesh = reconstruct(hollow_box(width, 15000, seed).points());
      EXPECT_EQ(0U, count_edges(mesh.positions, mesh.triangles).non_manifold) << width << ", " << seed;
      expect_manifold(mesh);
    }
  }
}

}  // namespace
}  // namespace glark::reconstruct::test
