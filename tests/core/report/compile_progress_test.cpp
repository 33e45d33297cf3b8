// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/compile_progress.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

TEST(CompileProgress, TheFirstProgramIsToldToThoseWhoWantInformation) {
  CompileProgress progress;
  const auto line = progress.compiled(0.25, 6);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->level, LogLevel::info);
  EXPECT_EQ(line->text, "compiling 1 of 7 shader programs for refined draws, 0.2 s so far");
}

TEST(CompileProgress, AWaitThatAUserNoticesIsToldAfterOneTwoAndFourSeconds) {
  CompileProgress progress;
  std::vector<double> told;
  for (int program = 1; program <= 50; ++program) {
    const auto line = progress.compiled(0.1, 50);
    if (line && line->level == LogLevel::progress) told.push_back(program / 10.0);
  }
  EXPECT_EQ(told.size(), 3u);
  EXPECT_NEAR(told[0], 1, 0.11);
  EXPECT_NEAR(told[1], 2, 0.11);
  EXPECT_NEAR(told[2], 4, 0.11);
}

TEST(CompileProgress, AShortWaitEndsInALineOfInformation) {
  CompileProgress progress;
  progress.compiled(0.25, 1);
  progress.compiled(0.25, 0);
  progress.add(0.25);
  const auto line = progress.finished();
  ASSERT_TRUE(line);
  EXPECT_EQ(line->level, LogLevel::info);
  EXPECT_EQ(line->text, "compiled 2 shader programs for refined draws in 0.8 s");
  EXPECT_FALSE(progress.finished());
}

TEST(CompileProgress, WhoSawTheBeginningOfALongWaitSeesItsEnd) {
  CompileProgress progress;
  progress.compiled(1.5, 0);
  const auto line = progress.finished();
  ASSERT_TRUE(line);
  EXPECT_EQ(line->level, LogLevel::progress);
  EXPECT_EQ(progress.compiled(0.1, 0)->level, LogLevel::info) << "the next wait is another one";
}

}  // namespace
}  // namespace glark::core
