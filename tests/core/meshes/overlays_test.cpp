// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/overlays.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

constexpr MeshKey overlaid_ball{{7, 12, 0}};
constexpr MeshKey wires_of_ball{{8, 12, 0}};

std::vector<Point> row_of_points(float first, int count) {
  std::vector<Point> result;
  for (int i = 0; i < count; ++i) result.push_back({first + static_cast<float>(i), 1, 2});
  return result;
}

TEST(Overlays, PointsAreCountedOnce) {
  EXPECT_EQ(distinct_points({}).size(), 0U);
  EXPECT_EQ(distinct_points(std::vector<Point>{{1, 2, 3}, {3, 2, 1}, {1, 2, 3}, {0, 0, 0}, {-0.F, 0, 0}}).size(), 3U);
}

TEST(Overlays, LieOnAMeshByHalfOfTheirPointsOrAQuarterOfIts) {
  const auto mesh = distinct_points(row_of_points(0, 40));
  EXPECT_TRUE(lies_on(distinct_points(row_of_points(30, 20)), mesh)) << "half of the overlay's";
  EXPECT_FALSE(lies_on(distinct_points(row_of_points(31, 19)), mesh));
  EXPECT_TRUE(lies_on(distinct_points(row_of_points(30, 100)), mesh)) << "a quarter of the mesh's";
  EXPECT_TRUE(lies_on(distinct_points(row_of_points(0, 3)), mesh));
  EXPECT_FALSE(lies_on(distinct_points(row_of_points(0, 2)), mesh)) << "two points may be equal by chance";
  EXPECT_FALSE(lies_on(distinct_points(row_of_points(0.5F, 40)), mesh));
}

TEST(Overlays, CoverAMeshThatComesBeforeOrAfter) {
  Overlays overlays;
  EXPECT_FALSE(overlays.wants_mesh(overlaid_ball)) << "nothing can lie on it";
  overlays.add_overlay(wires_of_ball, row_of_points(0, 8));
  EXPECT_FALSE(overlays.wants_overlay(wires_of_ball));
  EXPECT_TRUE(overlays.wants_mesh(overlaid_ball));
  overlays.add_mesh(overlaid_ball, row_of_points(0, 8));
  EXPECT_TRUE(overlays.covers(overlaid_ball));
  overlays = {};
  overlays.add_overlay(wires_of_ball, row_of_points(20, 8));
  overlays.add_mesh(overlaid_ball, row_of_points(0, 8));
  EXPECT_FALSE(overlays.covers(overlaid_ball));
  overlays.add_overlay({{9, 12, 0}}, row_of_points(0, 8));
  EXPECT_TRUE(overlays.covers(overlaid_ball));
}

// Lines that have a new buffer in each frame are read back a limited number of times.
TEST(Overlays, SourcesAreLimited) {
  Overlays overlays;
  for (std::uint64_t i = 0; i < Overlays::most_sources; ++i) {
    ASSERT_TRUE(overlays.wants_overlay({{i + 1, 0, 0}}));
    overlays.add_overlay({{i + 1, 0, 0}}, {});
  }
  EXPECT_FALSE(overlays.wants_overlay(wires_of_ball));
  EXPECT_TRUE(overlays.wants_mesh(overlaid_ball));
}

TEST(Overlays, AMeshDoesNotLieOnItself) {
  Overlays overlays;
  overlays.add_overlay(overlaid_ball, row_of_points(0, 8));
  overlays.add_mesh(overlaid_ball, row_of_points(0, 8));
  EXPECT_FALSE(overlays.covers(overlaid_ball));
}

}  // namespace
}  // namespace glark::core
