// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/output/triangle_strips.h"

#include <gtest/gtest.h>

namespace glark::maps {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(TriangleStrips, NeighboursAreOneStripInTheirOrientation) {
  const TriangleStrips strips = strips_of(Indices{0, 1, 2, 2, 1, 3, 2, 3, 4});
  EXPECT_EQ(strips.sizes, Indices{5});
  EXPECT_EQ(strips.vertices, (Indices{0, 1, 2, 3, 4}));
}

TEST(TriangleStrips, TrianglesWoundToOtherSidesAreApart) {
  const TriangleStrips strips = strips_of(Indices{0, 1, 2, 1, 2, 3});
  EXPECT_EQ(strips.sizes, (Indices{3, 3}));
  EXPECT_EQ(strips.vertices, (Indices{0, 1, 2, 1, 2, 3}));
}

TEST(TriangleStrips, ThreeTrianglesAtAnEdgeAreAllThere) {
  EXPECT_EQ(strips_of(Indices{0, 1, 2, 1, 0, 3, 1, 0, 4}).sizes, (Indices{4, 3}));
  EXPECT_EQ(strips_of(Indices{0, 1, 2, 0, 1, 2}).sizes, (Indices{3, 3}));
}

TEST(TriangleStrips, TrianglesWithoutAreaAreLeftOut) {
  EXPECT_TRUE(strips_of(Indices{0, 0, 1}).sizes.empty());
  EXPECT_TRUE(strips_of({}).vertices.empty());
}

TEST(TriangleStrips, ARingEnds) { EXPECT_EQ(strips_of(Indices{0, 1, 2, 2, 1, 3, 2, 3, 0, 0, 3, 1}).sizes.front(), 6U); }

}  // namespace
}  // namespace glark::maps
