// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/mesh/reindex.h"

#include "glark/clients/common/mesh/cut_sheets.h"
#include "tests/vstree/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace glark::common::test {
namespace {

using Indices = std::vector<std::uint32_t>;
using Flags = std::vector<std::uint8_t>;

Flags none_irregular(std::size_t count) {
  Flags flags(count);
  return flags;
}

TEST(IrregularVertices, AreNotThoseOfFans) {
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}, 4), none_irregular(4));  // a tetrahedron
  EXPECT_EQ(irregular_vertices(Indices{0, 3, 4, 0, 1, 2, 0, 2, 3}, 6),
            none_irregular(6));  // open, in any order; 5 has none
}

TEST(IrregularVertices, AreThoseOfMoreThanOneFan) {
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 0, 3, 4}, 5), (Flags{1, 0, 0, 0, 0}));
  // Two rings around one.
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 4, 5, 0, 5, 6, 0, 6, 4}, 7),
            (Flags{1, 0, 0, 0, 0, 0, 0}));
}

TEST(IrregularVertices, AreTheEndsOfEdgesWithMoreThanTwoTriangles) {
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 1, 0, 3, 0, 1, 4}, 5), (Flags{1, 1, 0, 0, 0}));
  // A path that runs into itself after as many steps as there are triangles.
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 2}, 5)[0], 1);
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 0, 1, 3}, 4)[0], 1);  // two triangles that run the same way
}

TEST(IrregularVertices, AreTheCornersOfRepeatedTriangles) {
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 1, 2, 0}, 3), (Flags{1, 1, 1}));
  EXPECT_EQ(irregular_vertices(Indices{0, 1, 2, 0, 2, 1}, 3), (Flags{1, 1, 1}));
}

Indices once(const Indices& triangles, std::size_t vertices) {
  return without_repeats(triangles, irregular_vertices(triangles, vertices));
}

TEST(WithoutRepeats, KeepsOneOfEachAndCancelsReversedOnes) {
  EXPECT_EQ(once({0, 1, 2, 1, 2, 3, 2, 0, 1}, 4), (Indices{0, 1, 2, 1, 2, 3}));
  EXPECT_EQ(once({0, 1, 2, 1, 2, 3, 0, 2, 1}, 4), (Indices{1, 2, 3}));
  EXPECT_EQ(once({0, 1, 2, 1, 0, 2, 2, 1, 0}, 3), (Indices{0, 2, 1}));  // most run the other way
  EXPECT_EQ(once({}, 3), Indices{});
}

// Vertices that are not irregular are skipped. Treating all vertices as irregular gives the same result.
TEST(CutSheets, SkipsRegularVerticesWithTheSameResult) {
  std::mt19937 random(3);
  const vstree::test::Shape shape = vstree::test::torus(40);
  for (int round = 0; round < 20; ++round) {
    Indices cluster_of(shape.size());
    for (std::uint32_t& cluster : cluster_of) cluster = static_cast<std::uint32_t>(random() % 120);
    const std::vector<Float4> points(120, Float4{});
    Indices triangles = spanning(shape.triangles, cluster_of, Workers(1));
    triangles.resize(triangles.size() / 9 * 3);
    const Flags irregular = irregular_vertices(triangles, points.size());
    const Flags all(points.size(), 1);
    Indices some = without_repeats(triangles, irregular), same = without_repeats(triangles, all);
    ASSERT_EQ(some, same);
    EXPECT_EQ(cut_sheets(some, points, irregular), cut_sheets(same, points, all));
    EXPECT_EQ(some, same);
  }
}

}  // namespace
}  // namespace glark::common::test
