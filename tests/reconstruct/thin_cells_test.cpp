// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lines on the faces of cells whose edges are crossed several times.
#include "glark/clients/reconstruct/contour/thin_cells.h"

#include <gtest/gtest.h>

namespace glark::reconstruct::test {
namespace {

constexpr Float4 up{0, 0, 1, 0}, down{0, 0, -1, 0};

FaceCrossing crossing(float x, float z, Float4 normal) { return {0, Float4{x, 0, z, 0}, normal}; }

TEST(FaceLines, ABandIsNotCapped) {
  // Up the right edge, then down the left one.
  EXPECT_EQ(
      lines_of_face({crossing(1, 0.4F, down), crossing(1, 0.6F, up), crossing(0, 0.6F, up), crossing(0, 0.4F, down)}),
      (std::vector<std::uint32_t>{3, 2, 1, 0}));
}

TEST(FaceLines, ABandThatEndsIsCapped) {
  EXPECT_EQ(lines_of_face({crossing(1, 0.4F, down), crossing(1, 0.6F, up)}), (std::vector<std::uint32_t>{1, 0}));
}

TEST(FaceLines, TwoBandsStayApart) {
  EXPECT_EQ(
      lines_of_face({crossing(1, 0.1F, down), crossing(1, 0.3F, up), crossing(1, 0.6F, down), crossing(1, 0.8F, up),
                     crossing(0, 0.8F, up), crossing(0, 0.6F, down), crossing(0, 0.3F, up), crossing(0, 0.1F, down)}),
      (std::vector<std::uint32_t>{7, 6, 5, 4, 3, 2, 1, 0}));
}

TEST(FaceLines, OfNoCrossingsAreNone) { EXPECT_TRUE(lines_of_face({}).empty()); }

// A plate crosses the upright edges of the cell twice each.
TEST(ThinCells, APlateHasTwoSheets) {
  ThinEdges edges;
  for (const std::int32_t x : {4, 5}) {
    for (const std::int32_t y : {4, 5}) edges.add({x, y, 4}, 2, std::vector<Crossing>{{0.4F, down}, {0.7F, up}});
  }
  const ThinCell cell({4, 4, 4}, {1, 1, 1, 1, 1, 1, 1, 1}, edges);
  ASSERT_EQ(cell.sheets().size(), 2U);
  for (const unsigned edge : {8U, 9U, 10U, 11U}) {
    ASSERT_EQ(cell.crossings_of(edge), 2U);
    EXPECT_FLOAT_EQ(cell.sheets()[cell.sheet_of(edge, 0)][2], 0.4F);
    EXPECT_FLOAT_EQ(cell.sheets()[cell.sheet_of(edge, 1)][2], 0.7F);
  }
}

// Only one edge is crossed: the sheet ends within the cell.
TEST(ThinCells, ARimHasOneSheet) {
  ThinEdges edges;
  edges.add({4, 4, 4}, 2, std::vector<Crossing>{{0.4F, down}, {0.7F, up}});
  const ThinCell cell({4, 4, 4}, {1, 1, 1, 1, 1, 1, 1, 1}, edges);
  ASSERT_EQ(cell.sheets().size(), 1U);
  EXPECT_EQ(cell.sheet_of(8, 0), cell.sheet_of(8, 1));
}

}  // namespace
}  // namespace glark::reconstruct::test
