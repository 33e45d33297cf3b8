// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/combinations.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace glark::conformance {
namespace {

constexpr std::size_t changes = 200, paths = 13;

// The values of a combination, in an order of its own.
std::array<int, 5> values_of(const Combination& one) {
  return {static_cast<int>(one.path), static_cast<int>(one.refinement), static_cast<int>(one.depths), one.history,
          one.triangles};
}

constexpr std::array<std::size_t, 5> counts = {paths, refinement_count, depths_names.size(), histories.size(),
                                               sizes.size()};

TEST(Combinations, EachChangeMeetsEachValue) {
  for (std::size_t change = 0; change < changes; ++change)
    for (std::size_t i = 0; i < counts.size(); ++i) {
      std::set<int> values;
      for (const Combination& one : combinations_of(change, paths)) values.insert(values_of(one).at(i));
      EXPECT_EQ(values.size(), counts.at(i)) << "change " << change << ", circumstance " << i;
    }
}

TEST(Combinations, EachTwoValuesMeet) {
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      std::set<std::pair<int, int>> pairs;
      for (std::size_t change = 0; change < 72; ++change)
        for (const Combination& one : combinations_of(change, paths))
          pairs.emplace(values_of(one).at(i), values_of(one).at(j));
      EXPECT_EQ(pairs.size(), counts.at(i) * counts.at(j)) << i << " and " << j;
    }
}

}  // namespace
}  // namespace glark::conformance
