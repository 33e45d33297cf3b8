// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/programs/compile_choice.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

constexpr bool first_frame = false;
constexpr bool later = true;

TEST(CompilePaces, SmoothNeverWaits) {
  const ContextOptions options{.transparent = true, .smooth = true, .wait = false};
  EXPECT_EQ(compile_pace(options, {}, first_frame), CompilePace::spread);
  EXPECT_EQ(compile_pace(options, {}, later), CompilePace::spread);
}

TEST(CompilePaces, AProgramThatShowsOnePictureIsRefined) {
  const ContextOptions options{.transparent = true, .smooth = false, .wait = false};
  EXPECT_EQ(compile_pace(options, {}, first_frame), CompilePace::at_once);
  EXPECT_EQ(compile_pace(options, {}, later), CompilePace::spread);
}

TEST(CompilePaces, TheUserMayWantToWait) {
  EXPECT_EQ(compile_pace({.transparent = true, .smooth = true, .wait = true}, {}, later), CompilePace::at_once);
}

TEST(CompilePaces, ProgramsThatCallTheExtensionAlwaysWait) {
  EXPECT_EQ(compile_pace({.transparent = false, .wait = false}, {}, later), CompilePace::at_once);
  ArkState calling;
  calling.enabled = true;
  EXPECT_EQ(compile_pace({.transparent = true, .smooth = true, .wait = false}, calling, later), CompilePace::at_once);
}

}  // namespace
}  // namespace glark::core
