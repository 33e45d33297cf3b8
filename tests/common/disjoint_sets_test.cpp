// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/disjoint_sets.h"

#include <gtest/gtest.h>

namespace glark::common::test {
namespace {

TEST(DisjointSets, AreSingleNumbersAtFirst) {
  DisjointSets sets(3);
  EXPECT_EQ(sets.size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, HaveTheirLeastNumberAsRoot) {
  DisjointSets sets(6);
  EXPECT_TRUE(sets.join(5, 3));
  EXPECT_TRUE(sets.join(4, 5));
  EXPECT_TRUE(sets.join(1, 2));
  for (const std::uint32_t i : {3U, 4U, 5U}) EXPECT_EQ(sets.find(i), 3U);
  EXPECT_EQ(sets.find(2), 1U);
  EXPECT_EQ(sets.find(0), 0U);
}

TEST(DisjointSets, TellWhetherTheyWereJoinedBefore) {
  DisjointSets sets(3);
  EXPECT_TRUE(sets.join(0, 1));
  EXPECT_TRUE(sets.join(1, 2));
  EXPECT_FALSE(sets.join(2, 0));
}

}  // namespace
}  // namespace glark::common::test
