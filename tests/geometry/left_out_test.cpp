// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts of the points that a mesh leaves out.
#include "glark/clients/geometry/measure/left_out.h"

#include <gtest/gtest.h>

namespace glark::geometry {
namespace {

// Two triangles, 100 by 100.
Geometry square() {
  Geometry mesh;
  mesh.positions = {0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0};
  mesh.triangles = {0, 1, 2, 0, 2, 3};
  return mesh;
}

// 100 points in a row along the square, at a height above it.
Geometry row(float height) {
  Geometry points;
  for (int i = 0; i < 100; ++i) {
    const float along = static_cast<float>(i) + 0.3F;
    points.positions.insert(points.positions.end(), {along, along / 2, height});
  }
  return points;
}

TEST(PointsLeftOut, NearPointsNeverCount) {
  for (const float height : {-0.99F, 0.0F, 0.5F, 0.99F}) EXPECT_EQ(0U, points_left_out(row(height), square(), 1));
}

TEST(PointsLeftOut, FarPointsAlwaysCount) {
  for (const float height : {-6.1F, 6.1F, 1e6F}) {
    Geometry points = row(height);
    const Geometry near = row(0);
    if (height < 100) points.positions.insert(points.positions.end(), near.positions.begin(), near.positions.end());
    EXPECT_EQ(100U, points_left_out(points, square(), 1)) << height;
  }
}

TEST(PointsLeftOut, AMeshWithoutTrianglesLeavesOutAll) { EXPECT_EQ(100U, points_left_out(row(0), {}, 1)); }

TEST(PointsLeftOut, NoPointsAreNone) { EXPECT_EQ(0U, points_left_out({}, square(), 1)); }

}  // namespace
}  // namespace glark::geometry
