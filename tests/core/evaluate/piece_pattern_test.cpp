// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/piece_pattern.h"

#include <gtest/gtest.h>

#include <array>

namespace glark::evaluate {
namespace {

TEST(PiecePattern, HasEachVertexOnceInTheOrderOfItsUse) {
  const std::array<std::uint16_t, 9> indices{700, 9, 40, 40, 9, 41, 9, 700, 65535};
  const PiecePattern pattern = piece_pattern(indices);
  EXPECT_EQ(pattern.vertices, (std::vector<std::uint16_t>{700, 9, 40, 41, 65535}));
  EXPECT_EQ(pattern.indices, (std::vector<std::uint16_t>{0, 1, 2, 2, 1, 3, 1, 0, 4}));
}

TEST(PiecePattern, OfNoTrianglesIsEmpty) {
  EXPECT_TRUE(piece_pattern({}).vertices.empty());
  EXPECT_TRUE(piece_pattern({}).indices.empty());
}

}  // namespace
}  // namespace glark::evaluate
