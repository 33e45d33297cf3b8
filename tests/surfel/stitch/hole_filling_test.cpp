// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/stitch/hole_filling.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::surfel::test {
namespace {

using Corners = std::array<std::size_t, 3>;

float no_factor(std::size_t /*i*/, std::size_t /*j*/) { return 1; }

TEST(SurfelHoleFilling, TriangleIsFilledByItself) {
  const auto filled = fill_hole(3, no_factor, [](std::size_t, std::size_t, std::size_t) { return 1.0F; });
  EXPECT_EQ(filled, (std::vector<Corners>{{0, 1, 2}}));
}

TEST(SurfelHoleFilling, ChoosesTheCheaperDiagonal) {
  const auto cost = [](std::size_t i, std::size_t k, std::size_t j) {
    return i == 0 && k == 2 && j == 3 ? 1.0F : 5.0F;
  };
  EXPECT_EQ(fill_hole(4, no_factor, cost), (std::vector<Corners>{{0, 2, 3}, {0, 1, 2}}));
}

TEST(SurfelHoleFilling, ExpensiveChordsAreAvoided) {
  const auto factor = [](std::size_t i, std::size_t j) { return i == 0 && j == 2 ? 100.0F : 1.0F; };
  const auto cost = [](std::size_t, std::size_t, std::size_t) { return 1.0F; };
  EXPECT_EQ(fill_hole(4, factor, cost), (std::vector<Corners>{{0, 1, 3}, {1, 2, 3}}));
}

TEST(SurfelHoleFilling, InfiniteCostsLeaveTheHoleOpen) {
  EXPECT_TRUE(fill_hole(5, no_factor, [](std::size_t, std::size_t, std::size_t) { return infinite_cost; }).empty());
}

}  // namespace
}  // namespace glark::surfel::test
