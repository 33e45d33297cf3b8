// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "glark/tool/scan/bake/folds.h"

namespace glark::tool {
namespace {

// Two triangles that share an edge. The vertex of the lower one lies beyond the edge, so that it is folded.
geometry::Geometry folded_pair() {
  geometry::Geometry mesh;
  mesh.positions = {0, 0, 0, 2, 0, 0, 1, 2, 0, 1, 0.1F, 0};
  mesh.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  mesh.triangles = {0, 1, 2, 1, 0, 3};
  return mesh;
}

float doubled_area(const geometry::Geometry& mesh, std::size_t t) {
  const auto x = [&](std::size_t k) { return mesh.positions[3 * mesh.triangles[3 * t + k]]; };
  const auto y = [&](std::size_t k) { return mesh.positions[3 * mesh.triangles[3 * t + k] + 1]; };
  return (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
}

TEST(Unfold, FlipsTheEdgeOfAFoldedTriangle) {
  geometry::Geometry mesh = folded_pair();
  ASSERT_LT(doubled_area(mesh, 1), 0);
  EXPECT_EQ(unfold(mesh), 0U);
  EXPECT_GT(doubled_area(mesh, 0), 0);
  EXPECT_GT(doubled_area(mesh, 1), 0);
  EXPECT_NEAR(doubled_area(mesh, 0) + doubled_area(mesh, 1), 3.8F, 1e-6F);  // that of the quadrilateral
}

TEST(Unfold, LeavesMeshesWithoutFoldsAsTheyAre) {
  geometry::Geometry mesh = folded_pair();
  mesh.positions[10] = -1;
  const std::vector<std::uint32_t> before = mesh.triangles;
  EXPECT_EQ(unfold(mesh), 0U);
  EXPECT_EQ(mesh.triangles, before);
}

TEST(Unfold, CountsFoldsThatStay) {
  geometry::Geometry mesh = folded_pair();
  mesh.triangles = {1, 0, 3};  // no neighbour
  EXPECT_EQ(unfold(mesh), 1U);
}

// Three triangles around a vertex that lies outside of their outline. No flip is possible: all edges exist already.
geometry::Geometry folded_fan() {
  geometry::Geometry mesh;
  mesh.positions = {0, 0, 0, 2, 0, 0, 1, 2, 0, 1, -0.5F, 0};
  mesh.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  mesh.triangles = {0, 1, 3, 1, 2, 3, 2, 0, 3};
  return mesh;
}

TEST(Unfold, MovesAVertexBackIntoItsRing) {
  geometry::Geometry mesh = folded_fan();
  ASSERT_LT(doubled_area(mesh, 0), 0);
  EXPECT_EQ(unfold(mesh), 0U);
  for (std::size_t t = 0; t < 3; ++t) EXPECT_GT(doubled_area(mesh, t), 0);
  const geometry::Geometry before = folded_fan();
  EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.begin() + 9, mesh.positions.begin()));
}

TEST(Unfold, LeavesVerticesThatShareTheirPlace) {
  geometry::Geometry mesh = folded_fan();
  mesh.positions.insert(mesh.positions.end(), {1, -0.5F, 0});  // another part of the mesh, with other attributes
  mesh.normals.insert(mesh.normals.end(), {0, 0, 1});
  EXPECT_EQ(unfold(mesh), 1U);
  EXPECT_EQ(mesh.positions[10], -0.5F);
}

// A flip must not make an edge that other triangles have already.
TEST(Unfold, KeepsEdgesOfTwoTriangles) {
  geometry::Geometry mesh = folded_pair();
  mesh.positions.insert(mesh.positions.end(), {5, 1, 0});
  mesh.normals.insert(mesh.normals.end(), {0, 0, 1});
  mesh.triangles.insert(mesh.triangles.end(), {3, 4, 2});  // the edge between the opposite vertices
  const std::vector<std::uint32_t> before = mesh.triangles;
  EXPECT_EQ(unfold(mesh), 1U);
  EXPECT_EQ(mesh.triangles, before);
}

}  // namespace
}  // namespace glark::tool
