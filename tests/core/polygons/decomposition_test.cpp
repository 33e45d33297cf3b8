// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reads a decomposition from the captured numbers of a probe. GL may cut a quad along either diagonal and begin a
// triangle at any corner.
#include "glark/core/polygons/decomposition.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::polygons {
namespace {

using Corners = std::array<GLint, 4>;

std::optional<Decomposition> of(GLenum mode, const std::vector<float>& numbers) {
  return decomposition_of(mode, numbers);
}

TEST(Decomposition, QuadsAlongEitherDiagonal) {
  EXPECT_EQ(of(GL_QUADS, {0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7})->corners, (Corners{0, 1, 4, 2}));
  EXPECT_EQ(of(GL_QUADS, {1, 2, 0, 2, 3, 0, 5, 6, 4, 6, 7, 4})->corners, (Corners{2, 0, 1, 4}));
}

TEST(Decomposition, TheDiagonalPassesThroughCornersOfBothTriangles) {
  EXPECT_EQ(diagonal_of(*of(GL_QUADS, {0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7})), Diagonal::from_second);
  EXPECT_EQ(diagonal_of(*of(GL_QUADS, {1, 2, 3, 3, 0, 1, 5, 6, 7, 7, 4, 5})), Diagonal::from_second);
  EXPECT_EQ(diagonal_of(*of(GL_QUADS, {1, 2, 0, 2, 3, 0, 5, 6, 4, 6, 7, 4})), Diagonal::from_first);
  EXPECT_EQ(diagonal_of(*of(GL_QUAD_STRIP, {2, 0, 3, 0, 1, 3, 4, 2, 5, 2, 3, 5})), Diagonal::from_first);
}

using Common = std::array<int, 4>;

TEST(Decomposition, CommonCornersAreThoseOfAllTriangles) {
  EXPECT_EQ(of(GL_QUADS, {0, 1, 3, 1, 2, 3, 4, 5, 7, 5, 6, 7})->common_corners, (Common{-1, -1, -1, 2}));
  EXPECT_EQ(of(GL_QUADS, {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7})->common_corners, (Common{0, -1, -1, -1}));
  EXPECT_EQ(of(GL_QUAD_STRIP, {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4})->common_corners, (Common{0, -1, -1, -1}));
  EXPECT_EQ(of(GL_POLYGON, {1, 2, 0, 2, 3, 0, 3, 4, 0})->common_corners, (Common{2, -1, -1, -1}));
}

TEST(Decomposition, ProvokingVertexAlongTheBoundary) {
  EXPECT_EQ(provoking_vertex(GL_QUADS, false), 3);
  EXPECT_EQ(provoking_vertex(GL_QUAD_STRIP, false), 2) << "the last of the four vertices";
  EXPECT_EQ(provoking_vertex(GL_QUADS, true), 0);
  EXPECT_EQ(provoking_vertex(GL_POLYGON, false), 0);
}

TEST(Decomposition, QuadStripGoesAroundItsBoundary) {
  EXPECT_EQ(of(GL_QUAD_STRIP, {2, 0, 3, 0, 1, 3, 4, 2, 5, 2, 3, 5})->corners, (Corners{1, 4, 2, 0}));
}

TEST(Decomposition, FanFromAnyCorner) {
  EXPECT_EQ(of(GL_POLYGON, {0, 1, 2, 0, 2, 3, 0, 3, 4})->corners, (Corners{0, 1, 2, 0}));
  EXPECT_EQ(of(GL_POLYGON, {1, 2, 0, 2, 3, 0, 3, 4, 0})->corners, (Corners{2, 0, 1, 0}));
  EXPECT_TRUE(of(GL_POLYGON, {0, 1, 2, 0, 2, 3, 0, 3, 4})->fan);
}

TEST(Decomposition, RejectsTrianglesThatOverlap) {
  EXPECT_FALSE(of(GL_QUADS, {0, 1, 2, 1, 2, 3, 4, 5, 6, 5, 6, 7}));
  EXPECT_FALSE(of(GL_QUADS, {0, 1, 2, 0, 1, 2, 4, 5, 6, 4, 5, 6}));
}

TEST(Decomposition, RejectsTheOtherOrientation) {
  EXPECT_FALSE(of(GL_QUADS, {0, 3, 1, 1, 3, 2, 4, 7, 5, 5, 7, 6}));
  EXPECT_FALSE(of(GL_POLYGON, {0, 2, 1, 0, 3, 2, 0, 4, 3}));
}

TEST(Decomposition, RejectsQuadsThatAreCutDifferently) {
  EXPECT_FALSE(of(GL_QUADS, {0, 1, 3, 1, 2, 3, 4, 5, 6, 4, 6, 7}));
}

TEST(Decomposition, RejectsAnythingButOneFan) {
  EXPECT_FALSE(of(GL_POLYGON, {0, 1, 4, 1, 2, 4, 2, 3, 4}));
  EXPECT_FALSE(of(GL_POLYGON, {0, 1, 2, 0, 2, 3, 4, 0, 3}));
}

}  // namespace
}  // namespace glark::polygons
