// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/random_program.h"
#include "conformance/changes/shortest.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glark::conformance {
namespace {

RandomProgram program_of(int steps) {
  RandomProgram program;
  for (int i = 0; i < steps; ++i) program.steps.push_back({.draw = {.history = i}});
  return program;
}

bool has(const RandomProgram& program, int history) {
  return std::any_of(program.steps.begin(), program.steps.end(),
                     [&](const Step& step) { return step.draw.history == history; });
}

TEST(RandomProgram, ShortestKeepsOnlyTheStepsThatFail) {
  const auto fails = [](const RandomProgram& tried) { return has(tried, 3) && has(tried, 40) && has(tried, 41); };
  const RandomProgram best = shortest<RandomProgram>(program_of(60), fails, 300);
  ASSERT_EQ(best.steps.size(), 3U);
  EXPECT_TRUE(fails(best));
}

TEST(RandomProgram, ShortestEndsWhenItMayNotRunMore) {
  int runs = 0;
  const auto fails = [&](const RandomProgram& tried) {
    ++runs;
    return has(tried, 7);
  };
  EXPECT_TRUE(has(shortest<RandomProgram>(program_of(60), fails, 5), 7));
  EXPECT_LE(runs, 5);
}

TEST(RandomProgram, ShortestLeavesNoStepsOutThatAllFail) {
  const auto fails = [](const RandomProgram& tried) { return tried.steps.size() == 8; };
  EXPECT_EQ(shortest<RandomProgram>(program_of(8), fails, 300).steps.size(), 8U);
}

}  // namespace
}  // namespace glark::conformance
