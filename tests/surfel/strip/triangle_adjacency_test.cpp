// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/triangle_adjacency.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::surfel::test {
namespace {

constexpr std::uint32_t no_link = TriangleAdjacency::no_link;

TEST(SurfelTriangleAdjacency, LinksLeadAcrossCommonEdges) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {2, 1, 3}};
  TriangleAdjacency adjacency;
  adjacency.build(triangles);
  const std::uint32_t link = adjacency.links(0)[0];
  EXPECT_EQ(TriangleAdjacency::triangle_of(link), 1U);
  EXPECT_EQ(TriangleAdjacency::side_of(link), 2U);
  EXPECT_EQ(TriangleAdjacency::triangle_of(adjacency.links(1)[2]), 0U);
  EXPECT_EQ(adjacency.links(0)[1], no_link);
  EXPECT_EQ(adjacency.links(1)[0], no_link);
}

TEST(SurfelTriangleAdjacency, MirroredTrianglesAreNotNeighbours) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 1}};
  TriangleAdjacency adjacency;
  adjacency.build(triangles);
  for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
    for (const std::uint32_t link : adjacency.links(triangle)) EXPECT_EQ(link, no_link);
  }
}

}  // namespace
}  // namespace glark::surfel::test
