// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

// Moves the cap above z = 0.8 up, its middle the most.
std::vector<std::uint32_t> pull(Points& points, float by) {
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    float& z = points.positions[3 * i + 2];
    if (z < 0.8F) continue;
    z += by * (z - 0.8F);
    moved.push_back(i);
  }
  return moved;
}

void expect_closed(const Strips& strips, std::size_t points) {
  const Edges edges = count_edges(strips);
  EXPECT_LT(static_cast<double>(edges.border_other), 0.02 * static_cast<double>(edges.border_matched));
  EXPECT_NEAR(static_cast<double>(triangles(strips).size()), 2.0 * static_cast<double>(points),
              0.01 * static_cast<double>(points));
}

TEST(SurfelUpdate, GrowingCapStaysClosed) {
  Points points = sphere(20000);
  Strips strips(points.cloud());
  for (int step = 0; step < 5; ++step) {
    const auto moved = pull(points, 0.3F);
    strips.update(points.cloud(), moved);
    expect_closed(strips, points.size());
  }
}

TEST(SurfelUpdate, ReportsAllChangedIndicesAndFewOthers) {
  Points points = sphere(20000);
  Strips strips(points.cloud());
  const std::vector<std::uint32_t> before(strips.indices().begin(), strips.indices().end());
  const auto moved = pull(points, 0.1F);
  const auto changed = strips.update(points.cloud(), moved);
  std::vector<bool> may_differ(strips.indices().size(), false);
  std::size_t sum = 0;
  for (const Range& range : changed) {
    sum += range.count;
    for (std::size_t i = range.first; i < range.first + range.count; ++i) may_differ[i] = true;
  }
  EXPECT_LT(sum, before.size() / 3) << "a tenth of the points moved";
  for (std::size_t i = 0; i < before.size(); ++i) {
    ASSERT_TRUE(may_differ[i] || strips.indices()[i] == before[i]) << i;
  }
}

// Leaves may draw triangles with points that they did not take in.
TEST(SurfelUpdate, BoxesContainDrawnTriangles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> step(-0.05F, 0.05F);
  Points points = torus(1500);
  Strips strips(points.cloud(), {.leaf_points = 16});
  for (int round = 0; round < 60; ++round) {
    std::vector<std::uint32_t> moved;
    for (int i = 0; i < 30; ++i) moved.push_back(static_cast<std::uint32_t>(random() % points.size()));
    for (const std::uint32_t point : moved) {
      for (std::size_t k = 0; k < 3; ++k) points.positions[3 * point + k] += step(random);
    }
    strips.update(points.cloud(), moved);
    for (const Node& node : strips.nodes()) {
      if (node.left != none) continue;
      for (const std::uint32_t point : strips.indices().subspan(node.first, node.count)) {
        for (std::size_t k = 0; k < 3; ++k) {
          ASSERT_GE(points.positions[3 * point + k], node.low[k]) << round;
          ASSERT_LE(points.positions[3 * point + k], node.high[k]) << round;
        }
      }
    }
  }
}

TEST(SurfelUpdate, NoMovedPointsChangeNothing) {
  const Points points = sphere(5000);
  Strips strips(points.cloud());
  const std::vector<std::uint32_t> before(strips.indices().begin(), strips.indices().end());
  EXPECT_TRUE(strips.update(points.cloud(), {}).empty());
  EXPECT_TRUE(std::ranges::equal(strips.indices(), before));
}

// Edges are not flipped, because flips depend on the order of a strip.
TEST(SurfelUpdate, MovingThereAndBackRestoresTheTriangles) {
  const Points rest = sphere(10000);
  Strips strips(rest.cloud(), {.turn_edges = false});
  auto before = triangles(strips);
  Points points = rest;
  const auto moved = pull(points, 0.05F);
  strips.update(points.cloud(), moved);
  strips.update(rest.cloud(), moved);
  auto after = triangles(strips);
  for (auto* list : {&before, &after}) {
    for (Triangle& t : *list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(list->begin(), list->end());
  }
  std::vector<Triangle> differing;
  std::ranges::set_symmetric_difference(before, after, std::back_inserter(differing));
  EXPECT_LT(differing.size(), 20U);
}

TEST(SurfelUpdate, AcceptsMovesToEmptySpaceAndNewPoints) {
  Points points = sphere(10000);
  Strips strips(points.cloud(), {.levels = 2});
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < 2000; ++i) {  // the top of the sphere moves away as a whole
    for (std::size_t k = 0; k < 3; ++k) points.positions[3 * i + k] += k == 2 ? 3.0F : 0.0F;
    moved.push_back(i);
  }
  const Points more = sphere(3000);
  for (std::size_t i = 0; i < more.size(); ++i) {
    const float* p = &more.positions[3 * i];
    points.add({p[0] - 5, p[1], p[2]}, {p[0], p[1], p[2]});
  }
  strips.update(points.cloud(), moved);
  EXPECT_EQ(strips.point_count(), 13000U);
  std::size_t of_new = 0, across = 0;
  for (const Triangle& t : triangles(strips)) {
    const auto body = [](std::uint32_t i) { return i < 2000 ? 0 : i < 10000 ? 1 : 2; };
    across += body(t[0]) != body(t[1]) || body(t[1]) != body(t[2]) ? 1 : 0;
    of_new += body(t[0]) == 2 ? 1 : 0;
  }
  EXPECT_EQ(across, 0U);
  EXPECT_NEAR(static_cast<double>(of_new), 2.0 * 3000, 60);
  EXPECT_LT(strips.nodes().size(), 3 * 13000U / 10);
}

// Conflict regions reach into leaves that are not updated.
TEST(SurfelUpdate, NoisySheetHasNoDuplicateEdges) {
  Points points = plane(80, 0.005F);
  Strips strips(points.cloud());
  std::mt19937 random(9);
  std::uniform_real_distribution<float> shake(-0.004F, 0.004F);
  for (int round = 0; round < 6; ++round) {
    std::vector<std::uint32_t> moved;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const float dx = points.positions[3 * i] - 0.15F * static_cast<float>(round),
                  dy = points.positions[3 * i + 1] - 0.5F;
      if (dx * dx + dy * dy > 0.02F) continue;
      points.positions[3 * i + 2] += shake(random);
      moved.push_back(i);
    }
    strips.update(points.cloud(), moved);
    const Edges edges = count_edges(strips);
    EXPECT_EQ(edges.other, 0U) << round;
    EXPECT_LT(edges.single, 500U) << round;
  }
}

TEST(SurfelUpdate, AcceptsNewPointsOfAnEmptyCloud) {
  Strips strips({});
  const Points points = sphere(1000);
  strips.update(points.cloud(), {});
  EXPECT_NEAR(static_cast<double>(triangles(strips).size()), 2000, 20);
}

TEST(SurfelUpdate, RandomJumpsKeepIndicesValidAndBounded) {
  Points points = sphere(3000);
  Strips strips(points.cloud(), {.levels = 2});
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-2, 2);
  for (int round = 0; round < 16; ++round) {
    std::vector<std::uint32_t> moved;
    for (int i = 0; i < 300; ++i) {
      const auto point = static_cast<std::uint32_t>(random() % points.size());
      moved.push_back(point);
      for (std::size_t k = 0; k < 3; ++k) points.positions[3 * point + k] = round % 7 == 0 ? 0.5F : any(random);
    }
    strips.update(points.cloud(), moved);
    for (const std::uint32_t point : strips.indices()) ASSERT_LT(point, points.size());
  }
  EXPECT_LT(strips.indices().size(), 100000U);
}

// Points that wander around leave empty leaves behind.
TEST(SurfelUpdate, TreeStaysBounded) {
  Points points = sphere(4000);
  const Points rest = points;
  Strips strips(points.cloud());
  std::vector<std::uint32_t> moved(2000);
  std::iota(moved.begin(), moved.end(), 0U);
  std::mt19937 random(6);
  std::uniform_real_distribution<float> any(-9, 9);
  for (int round = 0; round < 200; ++round) {
    const std::array<float, 3> by = {any(random), any(random), 4};
    const float size = 0.5F + std::fabs(by[0]);
    for (const std::uint32_t i : moved) {
      for (std::size_t k = 0; k < 3; ++k) points.positions[3 * i + k] = size * rest.positions[3 * i + k] + by[k];
    }
    strips.update(points.cloud(), moved);
    ASSERT_LT(strips.nodes().size(), 1000U) << round;
  }
  const Edges edges = count_edges(strips);
  EXPECT_LT(edges.single, 200U) << "the boundaries of the halves";
  EXPECT_LT(edges.other, 20U);
}

TEST(SurfelUpdate, ResultDoesNotDependOnThreads) {
  std::vector<std::uint32_t> first;
  for (const unsigned threads : {1U, 3U}) {
    Points points = sphere(20000);
    Strips strips(points.cloud(), {.threads = threads});
    const auto moved = pull(points, 0.2F);
    strips.update(points.cloud(), moved);
    if (first.empty()) first.assign(strips.indices().begin(), strips.indices().end());
    EXPECT_TRUE(std::ranges::equal(strips.indices(), first));
  }
}

TEST(SurfelUpdate, ReportsNoEmptyRanges) {
  Points points = sphere(300);
  Strips strips(points.cloud());
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back(i);
  std::fill(points.positions.begin(), points.positions.end(), 0.5F);
  for (int round = 0; round < 2; ++round) {
    for (const Range& range : strips.update(points.cloud(), all)) EXPECT_GT(range.count, 0U);
    EXPECT_TRUE(triangles(strips).empty());
  }
}

TEST(SurfelUpdate, RejectedUpdatesChangeNothing) {
  Points points = sphere(1000);
  Strips strips(points.cloud());
  const std::vector<std::uint32_t> before(strips.indices().begin(), strips.indices().end());
  const std::vector<std::uint32_t> beyond = {1000};
  EXPECT_THROW(strips.update(points.cloud(), beyond), Error);
  const Points fewer = sphere(999);
  EXPECT_THROW(strips.update(fewer.cloud(), {}), Error);
  EXPECT_THROW(strips.update({points.positions, {}}, {}), Error);
  const std::vector<std::uint32_t> moved = {7};
  points.positions[3 * 7] = std::nanf("");
  EXPECT_THROW(strips.update(points.cloud(), moved), Error);
  EXPECT_TRUE(std::ranges::equal(strips.indices(), before));
}

}  // namespace
}  // namespace glark::surfel::test
