// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/nearness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace glark::surfel {
namespace {

using Place = Nearness::Place;

float distance_to(const std::vector<Place>& points, Place place) {
  float least = std::numeric_limits<float>::infinity();
  for (const Place& point : points) least = std::min(least, std::hypot(point[0] - place[0], point[1] - place[1]));
  return least;
}

class NearnessTest : public testing::Test {
 protected:
  // What is nearer by two cells is near; what is farther than a quarter more and two cells is not.
  void expect_right(const std::vector<Place>& points, float distance, float most, float extent) {
    Nearness nearness;
    nearness.begin(points, most);
    const float cell = (extent + 2 * most) / 60;
    std::uniform_real_distribution<float> within(-extent / 2 - 2 * most, extent / 2 + 2 * most);
    for (int i = 0; i < 4000; ++i) {
      const Place place = {within(random_), within(random_)};
      const float away = distance_to(points, place);
      if (away < distance - 2 * cell) {
        ASSERT_TRUE(nearness.is_near(place, distance)) << away;
      }
      if (away > 1.25F * distance + 2 * cell) {
        ASSERT_FALSE(nearness.is_near(place, distance)) << away;
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

TEST_F(NearnessTest, KnowsWhatIsNearToPoints) {
  const auto points = spread(40, 10, 10);
  for (const float distance : {0.5F, 1.0F, 1.2F, 2.5F}) expect_right(points, distance, 2.5F, 10);
}

TEST_F(NearnessTest, ThePointsMayLieOnALineOrBeOne) {
  expect_right(spread(40, 10, 0), 1, 1, 10);
  expect_right(spread(40, 0, 10), 1, 1, 10);
  expect_right({{0, 0}}, 1, 1, 0);
}

TEST_F(NearnessTest, OneMemoryServesManySets) {
  Nearness nearness;
  for (const float size : {1.0F, 100.0F, 1e-6F}) {
    const std::vector<Place> points = {{0, 0}, {size, size}};
    nearness.begin(points, size);
    EXPECT_TRUE(nearness.is_near({0, 0}, size / 4));
    EXPECT_TRUE(nearness.is_near({size, size}, size));
    EXPECT_FALSE(nearness.is_near({size, 0}, size / 4));
    EXPECT_FALSE(nearness.is_near({5 * size, 0}, size)) << "beyond all that was asked for";
  }
  nearness.begin(std::span<const Place>(), 0);
  EXPECT_FALSE(nearness.is_near({0, 0}, 0));
}

}  // namespace
}  // namespace glark::surfel
