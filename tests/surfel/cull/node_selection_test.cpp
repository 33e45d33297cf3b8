// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/surfel/clouds.h"
#include "tests/surfel/cull/views.h"

namespace glark::surfel::test {
namespace {

// Returns whether a triangle is visible: not outside a plane of the frustum, and counter-clockwise on the screen.
bool is_visible(const Points& points, const Matrix& matrix, const Triangle& triangle) {
  std::array<std::array<float, 4>, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = clip(matrix, &points.positions[3 * triangle[k]]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::all_of(p.begin(), p.end(), [&](const auto& c) { return c[axis] > c[3]; })) return false;
    if (std::all_of(p.begin(), p.end(), [&](const auto& c) { return c[axis] < -c[3]; })) return false;
  }
  const double determinant = double{p[0][0]} * (double{p[1][1]} * p[2][3] - double{p[1][3]} * p[2][1]) -
                             double{p[0][1]} * (double{p[1][0]} * p[2][3] - double{p[1][3]} * p[2][0]) +
                             double{p[0][3]} * (double{p[1][0]} * p[2][1] - double{p[1][1]} * p[2][0]);
  return determinant > 0;
}

// Expects that all visible triangles are drawn.
void expect_complete(const Points& points, const Strips& strips, const Matrix& matrix) {
  Frame frame;
  strips.select({.clip_from_object = matrix, .width = 100, .height = 100, .point_pixels = 0}, frame);
  std::set<std::size_t> drawn;
  for (const void* offset : frame.offsets) drawn.insert(reinterpret_cast<std::uintptr_t>(offset) / 4);
  std::size_t leaf = 0;
  const auto all = patches(strips);
  for (const Node& node : strips.nodes()) {
    if (node.left != none || node.count == 0) continue;
    for (const Triangle& triangle : all[leaf]) {
      ASSERT_TRUE(drawn.contains(node.first) || !is_visible(points, matrix, triangle)) << "patch " << leaf;
    }
    ++leaf;
  }
}

TEST(SurfelNodeSelection, DrawsAllVisibleTriangles) {
  const Points points = torus(20000);
  const Strips strips(points.cloud());
  for (const float z : {0.2F, 1.0F, 3.0F, 20.0F}) {
    expect_complete(points, strips, perspective(0.3F, 0, z));
    expect_complete(points, strips, perspective(1, 0.2F, z, 2));
  }
  expect_complete(points, strips, parallel(0.5F));
  expect_complete(points, strips, parallel(3));
}

// Squared lengths underflow.
TEST(SurfelNodeSelection, DrawsAllVisibleTrianglesOfATinyCloud) {
  constexpr float size = 1e-30F;
  Points points = torus(5000);
  for (float& coordinate : points.positions) coordinate *= size;
  const Strips strips(points.cloud(), {.leaf_points = 32});
  for (const float z : {0.2F, 1.0F, 3.0F, 20.0F}) {
    Matrix matrix = perspective(0.3F, 0, z);
    for (std::size_t i = 0; i < 12; ++i) matrix[i] /= size;
    expect_complete(points, strips, matrix);
  }
}

TEST(SurfelNodeSelection, CullsTheBackOfASphere) {
  const Strips strips(sphere(50000).cloud());
  Frame frame;
  View view{.clip_from_object = parallel(2), .width = 2000, .height = 2000};
  strips.select(view, frame);
  EXPECT_GT(frame.back_faces, 0U);
  EXPECT_LT(frame.indices, strips.indices().size() * 60 / 100);
  EXPECT_GT(frame.indices, strips.indices().size() * 45 / 100);
  view.cull_back_faces = false;
  strips.select(view, frame);
  EXPECT_EQ(frame.indices, strips.indices().size());
}

TEST(SurfelNodeSelection, CullsSubtreesOutsideTheFrustum) {
  const Strips strips(sphere(50000).cloud(), {.leaf_points = 40});
  Frame frame;
  View view{.clip_from_object = perspective(0, 0, 1.2F, 0.2F), .width = 500, .height = 500};
  strips.select(view, frame);
  EXPECT_GT(frame.out_of_frustum, 0U);
  EXPECT_LT(frame.indices, strips.indices().size() / 20);
  EXPECT_LT(frame.visited, strips.nodes().size() / 10) << "culled subtrees are not visited";
  view.cull_frustum = false;
  view.cull_back_faces = false;
  strips.select(view, frame);
  EXPECT_EQ(frame.indices, strips.indices().size());
}

TEST(SurfelNodeSelection, DrawsFarNodesAsPoints) {
  const Points points = sphere(50000);
  const Strips strips(points.cloud());
  Frame frame;
  strips.select({.clip_from_object = perspective(0, 0, 90), .width = 100, .height = 100}, frame);
  EXPECT_EQ(frame.strips, 0U);
  EXPECT_GT(frame.points.size(), 0U);
  EXPECT_LT(frame.points.size(), 100U);
  for (const std::uint32_t point : frame.points) EXPECT_LT(point, points.size());
  strips.select({.clip_from_object = perspective(0, 0, 3), .width = 1000, .height = 1000}, frame);
  EXPECT_TRUE(frame.points.empty());
}

TEST(SurfelNodeSelection, DrawsFarCloudsAtACoarserLevel) {
  const Strips strips(sphere(50000).cloud(), {.levels = 4});
  Frame frame;
  unsigned before = 0;
  for (const float z : {1.5F, 6.0F, 30.0F, 95.0F}) {
    strips.select({.clip_from_object = perspective(0, 0, z), .width = 500, .height = 500, .point_pixels = 0}, frame);
    EXPECT_GE(frame.level, before);
    before = frame.level;
    EXPECT_GT(frame.strips, 0U);
  }
  EXPECT_EQ(before, 3U);
  strips.select(
      {.clip_from_object = perspective(0, 0, 95), .width = 500, .height = 500, .point_pixels = 0, .level_pixels = 0},
      frame);
  EXPECT_EQ(frame.level, 0U);
}

}  // namespace
}  // namespace glark::surfel::test
