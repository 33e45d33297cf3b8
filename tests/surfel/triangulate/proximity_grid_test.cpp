// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/proximity_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace glark::surfel {
namespace {

using Place = ProximityGrid::Place;

float distance_to(const std::vector<Place>& points, Place place) {
  float least = std::numeric_limits<float>::infinity();
  for (const Place& point : points) least = std::min(least, std::hypot(point[0] - place[0], point[1] - place[1]));
  return least;
}

class SurfelProximityGrid : public testing::Test {
 protected:
  // The answer may be wrong within two cells, and near a distance that is a quarter larger.
  void expect_correct(const std::vector<Place>& points, float distance, float most, float extent) {
    ProximityGrid grid;
    grid.begin(points, most);
    const float cell = (extent + 2 * most) / 60;
    std::uniform_real_distribution<float> within(-extent / 2 - 2 * most, extent / 2 + 2 * most);
    for (int i = 0; i < 4000; ++i) {
      const Place place = {within(random_), within(random_)};
      const float away = distance_to(points, place);
      if (away < distance - 2 * cell) {
        ASSERT_TRUE(grid.is_near(place, distance)) << away;
      }
      if (away > 1.25F * distance + 2 * cell) {
        ASSERT_FALSE(grid.is_near(place, distance)) << away;
      }
    }
  }

  std::vector<Place> spread(std::size_t count, float width, float height) {
    std::uniform_real_distribution<float> x(-width / 2, width / 2), y(-height / 2, height / 2);
    std::vector<Place> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back({x(random_), y(random_)});
    return points;
  }

  std::mt19937 random_{7};
};

TEST_F(SurfelProximityGrid, FindsPlacesNearPoints) {
  const auto points = spread(40, 10, 10);
  for (const float distance : {0.5F, 1.0F, 1.2F, 2.5F}) expect_correct(points, distance, 2.5F, 10);
}

TEST_F(SurfelProximityGrid, AcceptsCollinearAndSinglePoints) {
  expect_correct(spread(40, 10, 0), 1, 1, 10);
  expect_correct(spread(40, 0, 10), 1, 1, 10);
  expect_correct({{0, 0}}, 1, 1, 0);
}

TEST_F(SurfelProximityGrid, IsReusableForOtherPoints) {
  ProximityGrid grid;
  for (const float size : {1.0F, 100.0F, 1e-6F}) {
    const std::vector<Place> points = {{0, 0}, {size, size}};
    grid.begin(points, size);
    EXPECT_TRUE(grid.is_near({0, 0}, size / 4));
    EXPECT_TRUE(grid.is_near({size, size}, size));
    EXPECT_FALSE(grid.is_near({size, 0}, size / 4));
    EXPECT_FALSE(grid.is_near({5 * size, 0}, size)) << "outside the grid";
  }
  grid.begin(std::span<const Place>(), 0);
  EXPECT_FALSE(grid.is_near({0, 0}, 0));
}

}  // namespace
}  // namespace glark::surfel
