// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/track/filled_draws.h"

#include <gtest/gtest.h>

#include <array>

namespace glark::core::track::test {
namespace {

std::vector<GLsizei> counts_of(const FilledDraws& filled, std::size_t draws) {
  return {filled.counts(), filled.counts() + draws};
}

TEST(FilledDraws, AnEmptyDrawGetsOneVertexOfAnotherDraw) {
  const std::array<GLsizei, 4> count{0, 4, 0, 8};
  const std::array<GLint, 4> first{90, 10, 91, 20};
  const FilledDraws filled(GL_QUADS, count.data(), 4);
  ASSERT_TRUE(filled.needed());
  EXPECT_EQ(counts_of(filled, 4), (std::vector<GLsizei>{1, 4, 1, 8}));
  EXPECT_EQ(filled.arguments(first.data()), (std::vector<GLint>{10, 10, 10, 20}));
}

TEST(FilledDraws, QuadStripsAndPolygonsToo) {
  const std::array<GLsizei, 2> count{0, 5};
  EXPECT_TRUE(FilledDraws(GL_QUAD_STRIP, count.data(), 2).needed());
  EXPECT_TRUE(FilledDraws(GL_POLYGON, count.data(), 2).needed());
}

TEST(FilledDraws, TrianglesStayAsTheyAre) {
  const std::array<GLsizei, 2> count{0, 3};
  EXPECT_FALSE(FilledDraws(GL_TRIANGLES, count.data(), 2).needed());
  EXPECT_FALSE(FilledDraws(GL_TRIANGLE_FAN, count.data(), 2).needed());
}

TEST(FilledDraws, NothingToFillOrNothingToFillWith) {
  const std::array<GLsizei, 2> full{4, 4};
  const std::array<GLsizei, 2> empty{0, 0};
  EXPECT_FALSE(FilledDraws(GL_QUADS, full.data(), 2).needed());
  EXPECT_FALSE(FilledDraws(GL_QUADS, empty.data(), 2).needed());
  EXPECT_FALSE(FilledDraws(GL_QUADS, nullptr, 0).needed());
  EXPECT_FALSE(FilledDraws(GL_QUADS, nullptr, -1).needed());
}

// GL generates INVALID_VALUE, and draws nothing.
TEST(FilledDraws, ANegativeCountStays) {
  const std::array<GLsizei, 3> count{0, 4, -1};
  EXPECT_FALSE(FilledDraws(GL_QUADS, count.data(), 3).needed());
}

}  // namespace
}  // namespace glark::core::track::test
