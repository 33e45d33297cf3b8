// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/expand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "glark/core/pattern/pieces.glsl.h"
#include "tests/core/pattern/assembly.h"

namespace glark::pattern {
namespace {

std::vector<int> pieces_of(int e0, int e1, int e2, Interior interior = Interior::minimum) {
  std::vector<int> pieces;
  for (const Instance& instance : expand(e0, e1, e2, interior)) pieces.push_back(instance.piece);
  return pieces;
}

TEST(Expand, EqualDepthsAreOneUniformPiece) {
  for (int m = 0; m <= 8; ++m) EXPECT_EQ(pieces_of(m, m, m), std::vector<int>{uniform_piece(m)});
}

TEST(Expand, EqualDeepDepthsAreTilesOfTheDeepestUniform) {
  EXPECT_EQ(pieces_of(9, 9, 9), std::vector<int>(4, uniform_piece(8)));
  EXPECT_EQ(pieces_of(11, 11, 11), std::vector<int>(64, uniform_piece(8)));
}

TEST(Expand, DepthZeroIsARotatedFan) {
  auto instances = expand(5, 0, 3, Interior::minimum);
  ASSERT_EQ(instances.size(), 1u);
  EXPECT_EQ(instances[0].piece, fan_piece(3, 5));
  EXPECT_EQ(instances[0].r, 1.0f);
}

TEST(Expand, DepthOneIsFourTiles) {
  EXPECT_EQ(pieces_of(1, 1, 3, Interior::parts),
            (std::vector<int>{fan_piece(0, 2), uniform_piece(0), uniform_piece(0), fan_piece(0, 2)}));
  EXPECT_EQ(pieces_of(1, 1, 6),
            (std::vector<int>{fan_piece(0, 5), uniform_piece(0), uniform_piece(0), fan_piece(0, 5)}));
}

TEST(Expand, MiddleDepthsAreInteriorAndSkirts) {
  EXPECT_EQ(pieces_of(4, 3, 6),
            (std::vector<int>{interior_piece(3), skirt_piece(3, 4), skirt_piece(3, 3), skirt_piece(3, 6)}));
  EXPECT_EQ(pieces_of(4, 3, 5, Interior::parts),
            (std::vector<int>{interior_piece(3), skirt_piece(3, 4), skirt_piece(3, 3), skirt_piece(3, 5)}));
}

TEST(Expand, ShallowDepthsAreOneRotatedPiece) {
  for (const std::array<int, 3> e : {std::array{1, 2, 3}, {3, 1, 2}, {2, 3, 1}}) {
    const auto instances = expand(e[0], e[1], e[2], Interior::minimum);
    ASSERT_EQ(instances.size(), 1u);
    EXPECT_EQ(instances[0].piece, whole_piece(1, 2, 3));
    EXPECT_EQ(instances[0].r, static_cast<float>(std::find(e.begin(), e.end(), 1) - e.begin()));
  }
  EXPECT_EQ(pieces_of(3, 5, 4), std::vector<int>{whole_piece(3, 5, 4)});
}

TEST(Expand, DeepDepthsAreTilesOfTheTileLevel) {
  auto pieces = pieces_of(7, 9, 11);
  EXPECT_EQ(std::count(pieces.begin(), pieces.end(), uniform_piece(6)), 1);
  EXPECT_EQ(std::count(pieces.begin(), pieces.end(), interior_piece(6)), 3);
  EXPECT_EQ(std::count(pieces.begin(), pieces.end(), skirt_piece(6, 8)), 2);
  EXPECT_EQ(std::count(pieces.begin(), pieces.end(), skirt_piece(6, 10)), 2);
}

TEST(Expand, InteriorsDifferFromThreeLevelsOn) {
  EXPECT_EQ(pieces_of(3, 3, 5, Interior::smooth), pieces_of(3, 3, 5, Interior::parts));
  EXPECT_NE(pieces_of(3, 3, 6, Interior::smooth), pieces_of(3, 3, 6));
  EXPECT_EQ(pieces_of(0, 2, 2, Interior::smooth), pieces_of(0, 2, 2));
  EXPECT_EQ(pieces_of(0, 1, 3, Interior::smooth),
            (std::vector<int>{interior_piece(2), skirt_piece(2, 0), skirt_piece(2, 1), skirt_piece(2, 3)}));
}

TEST(Expand, SmoothInteriorHasTheBetterLeastAngle) {
  Pool pool = build_pool(11);
  for (int m = 0; m <= 7; ++m) {
    for (int d = m + 3; d <= 11; ++d) {
      double minimum = least_angle(testing::assemble(pool, expand(m, m, d, Interior::minimum)));
      double smooth = least_angle(testing::assemble(pool, expand(m, m, d, Interior::smooth)));
      EXPECT_GT(smooth, 1.4 * minimum) << m << " " << m << " " << d;
    }
  }
}

TEST(Expand, RejectsDepthsOutsideTheRange) {
  EXPECT_THROW(expand(0, 12, 0, Interior::minimum), std::invalid_argument);
  EXPECT_THROW(expand(0, 0, -1, Interior::minimum), std::invalid_argument);
}

}  // namespace
}  // namespace glark::pattern
