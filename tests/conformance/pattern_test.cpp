// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/reference/pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glark::conformance::reference {
namespace {

constexpr std::int64_t half = unit / 2;
constexpr Weights a = {unit, 0, 0};
constexpr Weights b = {0, unit, 0};
constexpr Weights c = {0, 0, unit};
constexpr Weights ab = {half, half, 0};
constexpr Weights bc = {0, half, half};
constexpr Weights ca = {half, 0, half};

TEST(ReferencePattern, TagsAreRoundedHalfUpAndClamped) {
  EXPECT_EQ(depth_tag(2.5F, 6), 3);
  EXPECT_EQ(depth_tag(std::nextafter(2.5F, 0.0F), 6), 2);
  EXPECT_EQ(depth_tag(0.49999997F, 6), 0);
  EXPECT_EQ(depth_tag(-0.5F, 6), 0);
  EXPECT_EQ(depth_tag(7, 6), 6);
  EXPECT_EQ(depth_tag(-3, 6), 0);
  EXPECT_EQ(depth_tag(std::numeric_limits<float>::infinity(), 6), 6);
  EXPECT_EQ(depth_tag(-std::numeric_limits<float>::infinity(), 6), 0);
  EXPECT_EQ(depth_tag(std::numeric_limits<float>::quiet_NaN(), 6), 0);
}

TEST(ReferencePattern, EdgeDepthsAreMeansRoundedDown) {
  EXPECT_EQ(edge_depths({0, 1, 4}), (Depths{0, 2, 2}));
  EXPECT_EQ(edge_depths({3, 3, 0}), (Depths{3, 1, 1}));
}

TEST(ReferencePattern, CountsAreThoseOfTheFormula) {
  EXPECT_EQ(minimum_triangles({0, 0, 0}), 1);
  EXPECT_EQ(minimum_triangles({1, 0, 0}), 2);
  EXPECT_EQ(minimum_triangles({1, 1, 0}), 3);
  EXPECT_EQ(minimum_triangles({1, 1, 1}), 4);
  EXPECT_EQ(minimum_triangles({2, 2, 2}), 16);
  EXPECT_EQ(minimum_triangles({3, 2, 1}), 12);
}

TEST(ReferencePattern, TheVerticesOfTwoAreThreeInsideAndTwelveOnEdges) {
  const std::int64_t quarter = unit / 4;
  const std::vector<Weights> expected = {{quarter, quarter, half}, {quarter, half, quarter}, {half, quarter, quarter}};
  auto inside = inside_vertices(2);
  std::sort(inside.begin(), inside.end());
  EXPECT_EQ(inside, expected);
  EXPECT_EQ(minimum_vertices({2, 2, 2}).size(), 15U);
  EXPECT_EQ(minimum_vertices({1, 0, 0}), (std::vector<Weights>{c, b, ab, a}));
}

TEST(ReferencePattern, EdgesRunFromTheirCornerToTheNext) {
  EXPECT_EQ(edge_vertices(0, 1), (std::vector<Weights>{a, ab, b}));
  EXPECT_EQ(edge_vertices(1, 1), (std::vector<Weights>{b, bc, c}));
  EXPECT_EQ(edge_vertices(2, 1), (std::vector<Weights>{c, ca, a}));
}

TEST(ReferencePattern, PatternsDrawnByHandHaveNoFault) {
  EXPECT_EQ(fault_of_minimum({a, b, c}, {0, 0, 0}), "");
  EXPECT_EQ(fault_of_minimum({a, ab, c, ab, b, c}, {1, 0, 0}), "");
  EXPECT_EQ(fault_of_minimum({a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}, {1, 1, 1}), "");
  EXPECT_EQ(depths_found({a, ab, c, ab, b, c}), (Depths{1, 0, 0}));
}

TEST(ReferencePattern, EveryFaultIsFound) {
  EXPECT_NE(fault_of_pattern({}, {0, 0, 0}), "");
  EXPECT_NE(fault_of_pattern({a, c, b}, {0, 0, 0}), "") << "orientation";
  EXPECT_NE(fault_of_pattern({a, b, c, a, b, c}, {0, 0, 0}), "") << "overlap";
  EXPECT_NE(fault_of_pattern({a, ab, c}, {1, 0, 0}), "") << "a triangle is missing";
  EXPECT_NE(fault_of_pattern({a, ab, c, ab, b, c}, {0, 1, 0}), "") << "another edge";
  EXPECT_NE(fault_of_pattern({a, b, c}, {1, 0, 0}), "") << "an edge vertex is missing";
  const Weights off = {half - 1, half + 1, 0};
  EXPECT_NE(fault_of_pattern({a, off, c, off, b, c}, {1, 0, 0}), "") << "not in the middle";
  const Weights inside = {half, unit / 4, unit / 4};
  EXPECT_NE(fault_of_pattern({a, b, inside, b, c, inside, a, bc, c}, {0, 0, 0}), "") << "overlap";
  EXPECT_NE(fault_of_minimum({a, b, inside, b, c, inside, c, a, inside}, {0, 0, 0}), "") << "too many triangles";
  // The triangles on one side of an inner edge are split: a vertex lies inside the edge from ab to c.
  const Weights middle = {unit / 4, unit / 4, half};
  EXPECT_NE(fault_of_pattern({a, ab, c, ab, b, middle, middle, b, c}, {1, 0, 0}), "") << "T-vertex";
}

TEST(ReferencePattern, FourTrianglesOfOneSizeNeedNotBeCongruent) {
  EXPECT_NE(fault_of_pattern({a, ab, ca, ab, b, ca, b, bc, ca, bc, c, ca}, {1, 1, 1}), "");
}

TEST(ReferencePattern, WeightsOutsideOrWithAnotherSumAreNone) {
  EXPECT_EQ(exact_weights(0.5F, 0.25F, 0.25F), (Weights{half, unit / 4, unit / 4}));
  EXPECT_FALSE(exact_weights(0.5F, 0.5F, 0.25F).has_value());
  EXPECT_FALSE(exact_weights(1.5F, -0.5F, 0).has_value());
  EXPECT_FALSE(exact_weights(std::numeric_limits<float>::quiet_NaN(), 0, 1).has_value());
}

TEST(ReferencePattern, ProductsAndSumsAreRoundedByThemselves) {
  EXPECT_EQ(refined(0.1F, 0.1F, 7, ab), 0.1F);
  EXPECT_EQ(refined(1, 2, 4, {half, unit / 4, unit / 4}), 2.0F);
  // 2^23 + 1/2 is rounded to 2^23, twice. A sum that is rounded only once would be 2^23 + 1.
  EXPECT_EQ(refined(16777216, 2, 2, {half, unit / 4, unit / 4}), 8388608.0F);
}

}  // namespace
}  // namespace glark::conformance::reference
