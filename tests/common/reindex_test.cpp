// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/mesh/reindex.h"

#include "glark/clients/common/mesh/cut_sheets.h"
#include "tests/vstree/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>
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

TEST(WithoutRepeats, CancelsReversedOnes) {
  EXPECT_EQ(once({0, 1, 2, 1, 2, 3, 0, 2, 1}, 4), (Indices{1, 2, 3}));
  EXPECT_EQ(once({0, 1, 2, 1, 0, 2, 2, 1, 0}, 3), (Indices{1, 0, 2}));  // most run the other way
  EXPECT_EQ(once({}, 3), Indices{});
}

// Two sheets that face the same way may have a triangle in common. With only one of the two, both would have a hole.
TEST(WithoutRepeats, KeepsThoseOfSeveralSheets) {
  EXPECT_EQ(once({0, 1, 2, 1, 2, 3, 2, 0, 1}, 4), (Indices{0, 1, 2, 1, 2, 3, 2, 0, 1}));
  EXPECT_EQ(once({0, 1, 2, 2, 1, 0, 1, 2, 0, 2, 0, 1}, 3), (Indices{0, 1, 2, 1, 2, 0}));
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

int edges_of_more_than_two(const Indices& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    ++counts[std::minmax(triangles[i], triangles[i / 3 * 3 + (i + 1) % 3])];
  return static_cast<int>(std::ranges::count_if(counts, [](const auto& edge) { return edge.second > 2; }));
}

// Which triangles of an edge belong to one sheet is told by the edges beside it, and those may have the same question.
TEST(CutSheets, PartsTetrahedraThatShareSeveralEdges) {
  int shared = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate;
    std::vector<Float4> points;
    for (int i = 0; i < 7; ++i) points.push_back(Float4{coordinate(random), coordinate(random), coordinate(random), 0});
    Indices triangles;
    for (int i = 0; i < 4; ++i) {
      Indices v{0, 1, 2, 3, 4, 5, 6};
      std::ranges::shuffle(v, random);
      triangles.insert(triangles.end(), {v[0], v[1], v[2], v[0], v[3], v[1], v[1], v[3], v[2], v[2], v[3], v[0]});
    }
    shared += edges_of_more_than_two(triangles);
    const Indices originals = cut_sheets(triangles, points, irregular_vertices(triangles, points.size()));
    ASSERT_EQ(edges_of_more_than_two(triangles), 0) << "seed " << seed;
    for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(originals[i], i);
    ASSERT_LE(*std::ranges::max_element(originals), 6U);
  }
  EXPECT_GT(shared, 300);
}

}  // namespace
}  // namespace glark::common::test
