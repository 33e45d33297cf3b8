// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/unrefined/draw_rules.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace glark::core {

TEST(DrawRules, WithoutAMatchThereIsNone) {
  EXPECT_EQ(find_rule({}, {}), nullptr);
  const std::vector<DrawRule> rules{{.blend = true}};
  EXPECT_EQ(find_rule(rules, {.blend = false}), nullptr);
}

TEST(DrawRules, TheFirstThatMatchesApplies) {
  const std::vector<DrawRule> rules{{.depth_only = true, .refinement = Refinement::linear_outputs},
                                    {.depth_test = true, .refinement = Refinement::pn},
                                    {.refinement = std::nullopt}};
  EXPECT_EQ(find_rule(rules, {.depth_test = true, .depth_only = true}), rules.data());
  EXPECT_EQ(find_rule(rules, {.depth_test = true}), &rules[1]);
  EXPECT_EQ(find_rule(rules, {}), &rules[2]);
}

TEST(DrawRules, EveryConditionMustHold) {
  const DrawState state{.program = 7,
                        .fixed_function = true,
                        .depth_test = true,
                        .depth_writes = true,
                        .depth_function = GL_EQUAL,
                        .blend = true,
                        .color_writes = false,
                        .depth_only = true,
                        .viewport = {64, 32}};
  const DrawRule all{.program = 7,
                     .fixed_function = true,
                     .depth_test = true,
                     .depth_writes = true,
                     .depth_function = GL_EQUAL,
                     .blend = true,
                     .color_writes = false,
                     .depth_only = true,
                     .viewport = std::array<unsigned, 2>{64, 32},
                     .refinement = std::nullopt};
  EXPECT_NE(find_rule({&all, 1}, state), nullptr);
  std::vector<DrawState> others(9, state);
  others[0].program = 8;
  others[1].fixed_function = false;
  others[2].depth_test = false;
  others[3].depth_writes = false;
  others[4].depth_function = GL_LEQUAL;
  others[5].blend = false;
  others[6].color_writes = true;
  others[7].depth_only = false;
  others[8].viewport = {64, 33};
  for (const DrawState& other : others) EXPECT_EQ(find_rule({&all, 1}, other), nullptr);
}

}  // namespace glark::core
