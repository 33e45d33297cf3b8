// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/programs/compilation.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace glark::core {
namespace {

double seconds = 0;
double clock() { return seconds; }

std::vector<std::string>& lines() {
  static std::vector<std::string> told;
  return told;
}

class Compilations : public testing::Test {
 protected:
  Compilations() {
    seconds = 0;
    lines().clear();
    set_log_sink([](LogLevel, std::string_view line) { lines().emplace_back(line); });
    compilation_.begin_draw(CompilePace::spread);
  }
  ~Compilations() override { set_log_sink(nullptr); }

  // Compiles the program, if it may begin.
  bool compile(int program, double duration) {
    if (!compilation_.may_begin(&programs_.at(static_cast<std::size_t>(program)))) return false;
    const Compilation::Step step(compilation_);
    seconds += duration;
    return true;
  }

  gl::Dispatch gl_{};
  Compilation compilation_{gl_, clock};
  std::array<char, 8> programs_{};
};

TEST_F(Compilations, AFrameCompilesForALimitedTime) {
  EXPECT_TRUE(compile(0, 0.6 * Compilation::seconds_a_frame));
  EXPECT_TRUE(compile(1, 0.6 * Compilation::seconds_a_frame));
  EXPECT_FALSE(compilation_.refused());
  EXPECT_FALSE(compile(2, 0));
  EXPECT_TRUE(compilation_.refused());
  compilation_.frame_finished();
  compilation_.begin_draw(CompilePace::spread);
  EXPECT_TRUE(compile(2, 0));
  EXPECT_FALSE(compilation_.refused());
}

TEST_F(Compilations, AFrameCompilesAtLeastOneProgram) {
  const Compilation::Step draw(compilation_, Compilation::Step::Kind::first_draw);
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(compile(frame, 5));
    EXPECT_FALSE(compile(7, 5));
    compilation_.frame_finished();
  }
}

TEST_F(Compilations, AtOnceNothingWaits) {
  compilation_.begin_draw(CompilePace::at_once);
  for (int program = 0; program < 8; ++program) EXPECT_TRUE(compile(program, 5));
}

TEST_F(Compilations, WhatWaitsIsCountedOnceForEachProgram) {
  EXPECT_TRUE(compile(0, 0.5));
  for (int draw = 0; draw < 9; ++draw) {
    for (int program = 1; program < 4; ++program) EXPECT_FALSE(compile(program, 0));
  }
  compilation_.frame_finished();
  EXPECT_TRUE(compile(1, 0.75));
  compilation_.frame_finished();
  compilation_.frame_finished();
  ASSERT_EQ(lines().size(), 3u);
  EXPECT_EQ(lines()[1], "compiling 2 of 4 shader programs for refined draws, 1.2 s so far");
  EXPECT_EQ(lines()[2], "compiled 2 shader programs for refined draws in 1.2 s");
}

TEST_F(Compilations, InTurnsEverythingIsCompiledAndTheLogKnowsTheNumber) {
  std::array<bool, 4> built{};
  compilation_.begin_draw(CompilePace::at_once);
  const bool done = compilation_.at_once([&] {
    bool all = true;
    for (std::size_t i = 0; i < built.size(); ++i) {
      built.at(i) = built.at(i) || compile(static_cast<int>(i), 0.6);
      all = all && built.at(i);
    }
    return all;
  });
  EXPECT_TRUE(done);
  EXPECT_EQ(compilation_.pace(), CompilePace::at_once);
  EXPECT_FALSE(compilation_.refused());
  ASSERT_GE(lines().size(), 2u);
  EXPECT_EQ(lines()[1], "compiling 2 of 4 shader programs for refined draws, 1.2 s so far");
}

}  // namespace
}  // namespace glark::core
