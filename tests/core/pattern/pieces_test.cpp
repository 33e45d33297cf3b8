// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pieces.glsl.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::pattern {
namespace {

TEST(Pieces, NumbersFillTheTableOnce) {
  std::vector<int> numbers;
  for (int m = 0; m <= 8; ++m) numbers.push_back(uniform_piece(m));
  for (int m = 2; m <= 6; ++m) numbers.push_back(interior_piece(m));
  for (int m = 2; m <= 6; ++m) {
    for (int d = 0; d <= 11; ++d) numbers.push_back(skirt_piece(m, d));
  }
  for (int m = 2; m <= 6; ++m) {
    for (int d = 0; d <= 11; ++d) numbers.push_back(smooth_skirt_piece(m, d));
  }
  for (int b = 0; b <= 11; ++b) {
    for (int c = 0; c <= 11; ++c) numbers.push_back(fan_piece(b, c));
  }
  for (int m = 1; m <= 5; ++m) {
    for (int b = m; b <= 5; ++b) {
      for (int c = m; c <= 5; ++c) numbers.push_back(whole_piece(m, b, c));
    }
  }
  ASSERT_EQ(numbers.size(), static_cast<std::size_t>(piece_count));
  for (int k = 0; k < piece_count; ++k) EXPECT_EQ(numbers[static_cast<std::size_t>(k)], k);
}

}  // namespace
}  // namespace glark::pattern
