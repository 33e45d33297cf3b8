// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/submit/mode_changes.h"

#include <gtest/gtest.h>

namespace glark::submit {
namespace {

ModeChanges changes(const refine::FixedFunctionState& state, core::Program* owner = nullptr, bool two_side = false) {
  core::Program program;
  program.fixed_function = true;
  core::DrawPlan plan;
  plan.program = &program;
  plan.owner = owner;
  core::Bindings bindings;
  bindings.two_side = two_side;
  return mode_changes(plan, state, bindings);
}

TEST(ModeChanges, AProgramOfTheApplicationNeedsNone) {
  core::Program program;
  core::DrawPlan plan;
  plan.program = plan.owner = &program;
  const ModeChanges none = mode_changes(plan, {.lighting = true, .two_sided = true, .separate_specular = true}, {});
  EXPECT_FALSE(none.two_side || none.color_sum || none.point_size);
}

TEST(ModeChanges, TwoSidedLightingSelectsTheBackColour) {
  EXPECT_TRUE(changes({.two_sided = true}).two_side);
  EXPECT_FALSE(changes({.two_sided = true}, nullptr, true).two_side);
  EXPECT_FALSE(changes({}).two_side);
}

TEST(ModeChanges, TheSeparateSpecularColourIsAdded) {
  EXPECT_TRUE(changes({.lighting = true, .separate_specular = true}).color_sum);
  EXPECT_FALSE(changes({.separate_specular = true}).color_sum);
  EXPECT_FALSE(changes({.lighting = true, .separate_specular = true, .color_sum = true}).color_sum);
  core::Program fragments;
  EXPECT_FALSE(changes({.lighting = true, .separate_specular = true}, &fragments).color_sum);
}

TEST(ModeChanges, PointSizesAreTheFixedFunctions) {
  EXPECT_TRUE(changes({.point_size = true}).point_size);
  EXPECT_TRUE(changes({.program_point_size = true}).point_size);
  EXPECT_FALSE(changes({.point_size = true, .program_point_size = true}).point_size);
}

}  // namespace
}  // namespace glark::submit
