// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

TEST(SurfelDegenerateClouds, EmptyCloudHasNoStrips) {
  const Strips strips({});
  EXPECT_EQ(strips.indices().size(), 0U);
  ASSERT_EQ(strips.nodes().size(), 1U);
  Frame frame;
  strips.select({.clip_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, .width = 8, .height = 8}, frame);
  EXPECT_EQ(frame.draws(), 0);
}

TEST(SurfelDegenerateClouds, OneOrTwoPointsHaveNoStrips) {
  Points points;
  points.add({1, 2, 3}, {0, 0, 1});
  EXPECT_EQ(Strips(points.cloud(), {.levels = 4}).indices().size(), 0U);
  points.add({1, 2, 4}, {0, 0, 1});
  EXPECT_EQ(Strips(points.cloud()).indices().size(), 0U);
}

TEST(SurfelDegenerateClouds, DuplicatesAloneHaveNoStrips) {
  Points points;
  for (int i = 0; i < 1000000; ++i) points.add({0.1F, 0.2F, 0.3F}, {0, 1, 0});
  const Strips strips(points.cloud(), {.levels = 3});
  EXPECT_EQ(strips.indices().size(), 0U);
  EXPECT_EQ(strips.nodes().front().representative, 0U);
}

void expect_finite_cones(const Cloud& cloud) {
  const Strips strips(cloud, {.levels = 2});
  for (unsigned level = 0; level < strips.level_count(); ++level)
    for (const Node& node : strips.nodes(level)) {
      for (const float number : node.cone_apex) EXPECT_TRUE(std::isfinite(number)) << number;
      for (const float number : node.cone_axis) EXPECT_TRUE(std::isfinite(number)) << number;
      EXPECT_TRUE(std::isfinite(node.cone_sine));
    }
}

// The mean normal of two opposed triangles is zero, and no plane meets such an axis.
TEST(SurfelDegenerateClouds, ConesOfTinyCloudsAreFinite) {
  const std::vector<Points> normals = [] {
    std::vector<Points> clouds(5);
    for (std::size_t k = 0; k < clouds.size(); ++k)
      for (int i = 0; i < 4; ++i)
        clouds[k].add({k == 4 ? 7.0F : static_cast<float>(i % 2),
                       k == 4   ? 7.0F
                       : i >= 2 ? 1.0F
                                : 0.0F,
                       7},
                      {0, 0,
                       k == 1 && i % 2 == 0 ? -1.0F
                       : k == 2             ? 0.0F
                                            : 1.0F});
    for (std::size_t i = 2; i < 12; i += 3) clouds[3].normals[i - 2] = 1, clouds[3].normals[i] = 0;  // in the plane
    return clouds;
  }();
  for (const Points& points : normals)
    for (std::size_t count = 0; count <= 4; ++count)
      for (const float scale : {1.0F, 1e17F, 1e-30F}) {
        std::vector<float> positions(points.positions.begin(), points.positions.begin() + 3 * std::ptrdiff_t(count));
        for (float& x : positions) x *= scale;
        expect_finite_cones({positions, std::span(points.normals).first(3 * count)});
        expect_finite_cones({positions, {}});
      }
}

TEST(SurfelDegenerateClouds, FirstOfSeveralDuplicatesIsDrawn) {
  const Points once = sphere(2000);
  Points twice = once;
  for (std::size_t i = 0; i < once.positions.size(); ++i) {
    twice.positions.push_back(once.positions[i]);
    twice.normals.push_back(once.normals[i]);
  }
  const Strips strips(twice.cloud(), {.leaf_points = 80});
  for (const std::uint32_t point : strips.indices()) ASSERT_LT(point, 2000U);
  EXPECT_NEAR(static_cast<double>(triangles(strips).size()), 2.0 * 2000 - 4, 10);
}

TEST(SurfelDegenerateClouds, CollinearPointsHaveNoTriangles) {
  Points points;
  for (int i = 0; i < 1000; ++i) points.add({0.37F * static_cast<float>(i), 0, 0}, {0, 0, 1});
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 0U);
  for (std::size_t i = 0; i < points.size(); ++i) {  // rounding bends this line
    points.positions[3 * i + 1] = points.positions[3 * i] * 0.1234567F;
    points.positions[3 * i + 2] = points.positions[3 * i] * 0.7654321F;
  }
  const Strips strips(points.cloud());
  for (const std::uint32_t point : strips.indices()) ASSERT_LT(point, 1000U);
}

TEST(SurfelDegenerateClouds, ZeroNormalsAreIgnored) {
  Points points = plane(40, 0);
  for (std::size_t i = 0; i < points.normals.size(); i += 7) points.normals[i / 3 * 3 + 2] = 0;
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 2U * 39 * 39);
  std::fill(points.normals.begin(), points.normals.end(), 0.0F);
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 2U * 39 * 39);
}

TEST(SurfelDegenerateClouds, AcceptsNormalsOfAnyLengthAndOpposedNormals) {
  Points points = plane(40, 0);
  for (float& x : points.normals) x *= 1e-30F;
  EXPECT_EQ(triangles(Strips(points.cloud())).size(), 2U * 39 * 39);
  for (std::size_t i = 0; i < points.size(); i += 2) points.normals[3 * i + 2] = -1;
  const Strips strips(points.cloud());  // two layers in the same place
  EXPECT_GT(triangles(strips).size(), 0U);
}

TEST(SurfelDegenerateClouds, AcceptsVeryLargeAndSmallCoordinates) {
  for (const float scale : {1e18F, 1e-37F}) {
    Points points = sphere(500);
    for (float& x : points.positions) x *= 0.99F * scale;
    EXPECT_GT(triangles(Strips(points.cloud())).size(), 900U) << scale;
  }
}

}  // namespace
}  // namespace glark::surfel::test
