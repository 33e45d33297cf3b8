// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/draw_switch.h"

#include <gtest/gtest.h>

#include "glark/core/plan/unrefined/draw_rules.h"

namespace glark::shim {
namespace {

core::WatchedClass draws_of(std::uint64_t program, std::uint64_t pixel_step, std::optional<core::Cause> cause = {}) {
  core::WatchedClass draws;
  draws.key.state.program = program;
  draws.key.verdict.cause = cause;
  draws.pixel_step = pixel_step;
  return draws;
}

}  // namespace

TEST(DrawSwitch, ARuleLeavesExactlyTheseDrawsAlone) {
  core::ContextOptions options;
  core::DrawState state{.program = 7, .depth_test = true};
  switch_draws(options, state, false);
  EXPECT_TRUE(is_switched_off(options, state));
  ASSERT_NE(core::find_rule(options.rules, state), nullptr);
  EXPECT_EQ(core::find_rule(options.rules, state)->refinement, std::nullopt);
  state.viewport = {100, 50};
  EXPECT_TRUE(is_switched_off(options, state)) << "a window that is resized keeps the rule";
  state.blend = true;
  EXPECT_FALSE(is_switched_off(options, state));
  EXPECT_EQ(core::find_rule(options.rules, state), nullptr);
}

TEST(DrawSwitch, OnAgainRemovesTheRule) {
  core::ContextOptions options;
  options.rules.push_back({.blend = true});
  const core::DrawState state{.program = 7};
  switch_draws(options, state, false);
  switch_draws(options, state, false);
  EXPECT_EQ(options.rules.size(), 2U) << "a second switch adds nothing";
  EXPECT_EQ(options.rules.front().program, 7U) << "the first rule that matches counts";
  switch_draws(options, state, true);
  ASSERT_EQ(options.rules.size(), 1U);
  EXPECT_EQ(options.rules.front().blend, true);
}

TEST(SeenAtPixel, TheLastDrawThatChangedIt) {
  const std::vector classes{draws_of(1, 1), draws_of(2, 3), draws_of(3, 0)};
  ASSERT_TRUE(seen_at_pixel(classes));
  EXPECT_EQ(seen_at_pixel(classes)->program, 2U);
}

TEST(SeenAtPixel, AFullScreenPassHidesNothing) {
  EXPECT_EQ(seen_at_pixel({draws_of(1, 1), draws_of(2, 3, core::Cause::screen_quad)})->program, 1U);
  EXPECT_EQ(seen_at_pixel({draws_of(2, 3, core::Cause::screen_quad)})->program, 2U);
  EXPECT_EQ(seen_at_pixel({draws_of(1, 0)}), std::nullopt);
}

}  // namespace glark::shim
