// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/pattern/drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace glark::tool {
namespace {

using pattern::Interior;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

double area(const std::vector<PatternTriangle>& triangles) {
  double sum = 0;
  for (const auto& [corners, part] : triangles) {
    const auto& [a, b, c] = corners;
    sum += (b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v);
  }
  return sum;
}

// A lesson of the course derives it: n = 2^m for the least depth m, and n^2 - 3 n + 2^a + 2^b + 2^c triangles.
TEST(PatternDrawing, HasTheTrianglesOfTheFormula) {
  for (int a = 0; a <= 4; ++a)
    for (int b = 0; b <= 4; ++b)
      for (int c = 0; c <= 4; ++c) {
        const int n = 1 << std::min({a, b, c});
        const auto triangles = pattern_triangles({a, b, c}, Interior::parts);
        EXPECT_EQ(triangles.size(), static_cast<std::size_t>(n * n - 3 * n + (1 << a) + (1 << b) + (1 << c)))
            << a << b << c;
        EXPECT_DOUBLE_EQ(area(triangles), 1) << a << b << c;
      }
}

TEST(PatternDrawing, CoversTheTriangleWithEveryInterior) {
  for (const Interior interior : {Interior::minimum, Interior::parts, Interior::smooth, Interior::morphing})
    EXPECT_DOUBLE_EQ(area(pattern_triangles({2, 3, 5}, interior)), 1);
}

TEST(PatternDrawing, NamesTheParts) {
  std::array<int, 3> of_part{};
  for (const PatternTriangle& triangle : pattern_triangles({2, 3, 5}, Interior::parts))
    ++of_part[static_cast<std::size_t>(triangle.part)];
  // One inner triangle; each skirt joins the edge's segments to one inner segment.
  EXPECT_EQ(of_part, (std::array<int, 3>{1, 4 + 8 + 32 + 3, 0}));
}

TEST(PatternDrawing, WritesEveryTriangleAndEveryDepth) {
  const std::string svg = pattern_as_svg({0, 3, 1}, Interior::parts);
  EXPECT_EQ(count(svg, "<polygon"), 1 + 8 + 2 - 2);
  EXPECT_EQ(count(svg, "depth 0: 1 segment<"), 1);
  EXPECT_EQ(count(svg, "depth 3: 8 segments<"), 1);
  EXPECT_EQ(count(svg, "depth 1: 2 segments<"), 1);
}

TEST(PatternDrawing, RefusesDepthsThatNoPatternHas) {
  EXPECT_THROW(pattern_triangles({0, 0, 12}, Interior::parts), std::invalid_argument);
}

}  // namespace
}  // namespace glark::tool
