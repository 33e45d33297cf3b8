// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/directions.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::core {
namespace {

TEST(Directions, HaveTheLengthOne) {
  EXPECT_TRUE(are_directions({}));
  EXPECT_TRUE(are_directions(std::vector<Point>{{1, 0, 0}, {0, 0.6F, -0.8F}, {0, 0, 0}}));
  EXPECT_FALSE(are_directions(std::vector<Point>{{0.3F, 0.3F, 0}, {-0.3F, 0.3F, 0}}));
  EXPECT_FALSE(are_directions(std::vector<Point>{{0, 0, 2}, {0, 0, 1}}));
}

TEST(Directions, MayHaveAFewWrongOnesAmongThem) {
  std::vector<Point> normals(19, Point{0, 1, 0});
  normals.push_back({5, 5, 5});
  EXPECT_TRUE(are_directions(normals));
  normals.push_back({5, 5, 5});
  EXPECT_FALSE(are_directions(normals));
}

}  // namespace
}  // namespace glark::core
