// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

double area_facing_up(const Points& points, const std::vector<Triangle>& all) {
  double sum = 0;
  for (const auto& [a, b, c] : all) {
    const auto x = [&](std::uint32_t i) { return double{points.positions[3 * i]}; };
    const auto y = [&](std::uint32_t i) { return double{points.positions[3 * i + 1]}; };
    sum += 0.5 * ((x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a)));
  }
  return sum;
}

TEST(SurfelStrips, SphereIsClosed) {
  const Points points = sphere(20000);
  const Strips strips(points.cloud());
  const Edges edges = count_edges(strips);
  EXPECT_GT(edges.border_matched, 1000U);
  EXPECT_LT(static_cast<double>(edges.border_other), 0.005 * static_cast<double>(edges.border_matched));
  EXPECT_NEAR(static_cast<double>(triangles(strips).size()), 2.0 * 20000 - 4, 40);
}

TEST(SurfelStrips, PatchesOfATorusMatch) {
  const Points points = torus(20000);
  const Edges edges = count_edges(Strips(points.cloud()));
  EXPECT_EQ(edges.border_other, 0U);
}

// Squares of a grid have two equally good diagonals. All leaves must choose the same.
TEST(SurfelStrips, GridIsCoveredOnce) {
  const Points points = plane(100, 0);
  const Strips strips(points.cloud());
  EXPECT_EQ(triangles(strips).size(), 2U * 99 * 99);
  EXPECT_NEAR(area_facing_up(points, triangles(strips)), 1, 1e-4);
  const Edges edges = count_edges(strips);
  EXPECT_EQ(edges.single, 4U * 99);
  EXPECT_EQ(edges.other, 0U);
}

TEST(SurfelStrips, NoisyPlaneIsCovered) {
  const Points points = plane(100, 0.004F);
  const Strips strips(points.cloud());
  EXPECT_NEAR(area_facing_up(points, triangles(strips)), 1, 0.03);
  EXPECT_EQ(count_edges(strips).other, 0U);
}

TEST(SurfelStrips, CloseLayersStaySeparate) {
  const Points points = two_layers(60, 0.004F);  // a quarter of the points' distance
  const Strips strips(points.cloud());
  std::size_t across = 0;
  for (const Triangle& triangle : triangles(strips)) {
    const auto above = [](std::uint32_t i) { return i < 3600; };
    across += above(triangle[0]) != above(triangle[1]) || above(triangle[1]) != above(triangle[2]) ? 1 : 0;
  }
  EXPECT_EQ(across, 0U);
  EXPECT_NEAR(static_cast<double>(triangles(strips).size()), 4.0 * 59 * 59, 50);
}

// The cloud has single points, pairs, and three points in a row, far from all others or above the surface.
TEST(SurfelStrips, IsolatedPointsHaveNoLongTriangles) {
  Points points = sphere(5000);
  const auto add = [&](float x, float y, float z) { points.add({x, y, z}, {0, 0, 1}); };
  add(0, 0, 1.3F);
  add(0, 1.5F, 0);
  add(0, 1.5F, 0.01F);
  add(4, 0, 0);
  for (const float z : {0.0F, 0.01F, 0.02F}) add(-6, 0, z);
  const Strips strips(points.cloud());
  std::size_t on_a_line = 0;  // the last three points may have a degenerate triangle
  for (const auto& [a, b, c] : triangles(strips)) {
    on_a_line += std::min({a, b, c}) == 5004 ? 1 : 0;
    ASSERT_TRUE(std::min({a, b, c}) == 5004 || std::max({a, b, c}) < 5000) << a << ' ' << b << ' ' << c;
  }
  const Edges edges = count_edges(strips);
  EXPECT_EQ(edges.single, 3 * on_a_line) << "the surface is closed below them";
  EXPECT_EQ(edges.other, 0U);
}

// The boundaries of small pieces are as short as the boundaries of holes that are filled.
TEST(SurfelStrips, BoundariesOfSmallPiecesAreNotFilled) {
  for (const unsigned side : {2U, 3U, 5U, 9U}) {
    const Points points = plane(side, 0);
    const Strips strips(points.cloud());
    const std::vector<Triangle> all = triangles(strips);
    EXPECT_EQ(all.size(), 2UL * (side - 1) * (side - 1));
    EXPECT_NEAR(area_facing_up(points, all), 1, 1e-5) << "of " << side << " points a side";
    EXPECT_EQ(count_edges(strips).single, 4UL * (side - 1));
  }
}

// The bends of the sheet are hardly wider than the spacing of its points. So the planes of its leaves differ much.
TEST(SurfelStrips, CoarseFoldsHaveNoHolesAndNoDuplicateEdges) {
  Points points;
  constexpr unsigned side = 60;
  for (unsigned i = 0; i < side * side; ++i) {
    const unsigned column = i % side, row = i / side;
    const auto x = static_cast<float>(column), y = static_cast<float>(row) + 0.3F * static_cast<float>(i % 3);
    const float slope = 2.2F * std::cos(x * 1.1F);
    const float size = std::hypot(slope, 1.0F);
    points.add({x, y, 2 * std::sin(x * 1.1F)}, {-slope / size, 0, 1 / size});
  }
  const Edges edges = count_edges(Strips(points.cloud()));
  EXPECT_EQ(edges.other, 0U);
  EXPECT_LT(edges.single, 6U * side) << "its four sides";
}

TEST(SurfelStrips, EdgesOfACubeAreClosed) {
  const Points points = cube(40);
  const Edges edges = count_edges(Strips(points.cloud()));
  EXPECT_LT(edges.single, 40U) << "of " << 12 * 40 * 2 << " edges along those of the cube";
}

TEST(SurfelStrips, EveryPointIsDrawn) {
  const Points points = torus(5000);
  const Strips strips(points.cloud());
  std::set<std::uint32_t> drawn(strips.indices().begin(), strips.indices().end());
  EXPECT_EQ(drawn.size(), points.size());
}

TEST(SurfelStrips, TrianglesFaceTheDirectionOfNormals) {
  const Points points = sphere(5000);
  for (const auto& [a, b, c] : triangles(Strips(points.cloud()))) {
    std::array<float, 3> u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = points.positions[3 * b + k] - points.positions[3 * a + k];
      v[k] = points.positions[3 * c + k] - points.positions[3 * a + k];
    }
    const float outwards = (u[1] * v[2] - u[2] * v[1]) * points.positions[3 * a] +
                           (u[2] * v[0] - u[0] * v[2]) * points.positions[3 * a + 1] +
                           (u[0] * v[1] - u[1] * v[0]) * points.positions[3 * a + 2];
    ASSERT_GT(outwards, 0) << a << ' ' << b << ' ' << c;
  }
}

TEST(SurfelStrips, LeavesAreAtLeastHalfFull) {
  for (const unsigned most : {40U, 128U, 256U}) {
    const std::size_t leaves = Strips(sphere(10000).cloud(), {.leaf_points = most}).counts().strips;
    EXPECT_GE(leaves, 10000U / most);
    EXPECT_LE(leaves, 2 * 10000U / most);
  }
}

TEST(SurfelStrips, CountsDescribeTheStrips) {
  const Strips strips(torus(5000).cloud());
  const Counts counts = strips.counts();
  EXPECT_EQ(counts.valid, triangles(strips).size());
  EXPECT_EQ(counts.indices, strips.indices().size());
  EXPECT_EQ(counts.strips, patches(strips).size());
  EXPECT_GT(counts.outer, 0U);
  EXPECT_GT(counts.redundant, 0U);
}

TEST(SurfelStrips, FlippedEdgesSaveIndices) {
  const Points points = torus(5000);
  const Strips flipped(points.cloud()), exact(points.cloud(), {.turn_edges = false});
  EXPECT_GT(flipped.counts().turned, 200U);
  EXPECT_EQ(exact.counts().turned, 0U);
  EXPECT_EQ(flipped.counts().valid, exact.counts().valid);
  EXPECT_LT(flipped.counts().indices, exact.counts().indices);
  EXPECT_LT(static_cast<double>(flipped.counts().indices), 1.45 * static_cast<double>(flipped.counts().valid));
}

TEST(SurfelStrips, ResultDoesNotDependOnThreads) {
  const Points points = torus(50000);
  const Strips one(points.cloud(), {.levels = 3, .threads = 1});
  for (const unsigned threads : {2U, 5U, 0U}) {
    const Strips other(points.cloud(), {.levels = 3, .threads = threads});
    EXPECT_TRUE(std::ranges::equal(one.indices(), other.indices())) << threads;
  }
}

TEST(SurfelStrips, ResultDoesNotDependOnScale) {
  Points points = torus(5000);
  const Strips strips(points.cloud());
  for (float& x : points.positions) x *= 1024;
  EXPECT_TRUE(std::ranges::equal(strips.indices(), Strips(points.cloud()).indices()));
  for (float& x : points.positions) x *= 0x1p-100F;
  EXPECT_TRUE(std::ranges::equal(strips.indices(), Strips(points.cloud()).indices()));
}

TEST(SurfelStrips, LevelsHaveAQuarterOfThePoints) {
  const Points points = sphere(20000);
  const Strips strips(points.cloud(), {.levels = 3});
  ASSERT_EQ(strips.level_count(), 3U);
  for (unsigned level = 1; level < 3; ++level) {
    const auto finer = triangles(strips, level - 1), coarser = triangles(strips, level);
    EXPECT_GT(coarser.size(), finer.size() / 6);
    EXPECT_LT(coarser.size(), finer.size() / 3);
  }
}

TEST(SurfelStrips, PlaneIsCoveredWithoutNormals) {
  const Points points = plane(50, 0.002F);
  const Strips strips({points.positions, {}});
  EXPECT_NEAR(std::fabs(area_facing_up(points, triangles(strips))), 1, 0.03);
  for (const Node& node : strips.nodes()) EXPECT_GE(node.cone_sine, 1);
}

class SurfelScans : public testing::TestWithParam<const char*> {};

TEST_P(SurfelScans, PatchesMatch) {
  const auto points = scan(GetParam());
  if (!points) GTEST_SKIP() << GetParam() << ".ply.zst is not in ../shared/data, or zstd is missing";
  const Strips strips(points->cloud());
  const Edges edges = count_edges(strips);
  const auto matched = static_cast<double>(edges.border_matched), other = static_cast<double>(edges.border_other);
  EXPECT_GT(matched / (matched + other), 0.995) << other << " edges do not match";
}

INSTANTIATE_TEST_SUITE_P(All, SurfelScans,
                         testing::Values("igea", "bunny", "horse", "armadillo", "nefertiti", "bunny_scans"));

// Leaves have neighbours that are a million times sparser.
TEST(SurfelStrips, PointsOfAnyDensityHaveTriangles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  Points points;
  for (int i = 0; i < 30000; ++i) {
    const float size = std::exp2(-40 * uniform(random));
    points.add({size * (uniform(random) - 0.5F), size * (uniform(random) - 0.5F), 0}, {0, 0, 1});
  }
  for (const unsigned leaf_points : {32U, 192U}) {
    const Strips strips(points.cloud(), {.leaf_points = leaf_points});
    EXPECT_GT(triangles(strips).size(), 59000U);
  }
}

}  // namespace
}  // namespace glark::surfel::test
