// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/depths/depth_choice.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glark::core {
namespace {

ArkState with_tags(int pool_level = 6) {
  ArkState ark;
  ark.enabled = true;
  ark.pool_level = pool_level;
  return ark;
}

unsigned level_of_tag(double tag) {
  const ContextOptions options;
  const ArkState ark = with_tags();
  return choose_depths({.options = options, .ark = ark, .current_tag = tag}).level;
}

void give_stage(Program& program, GLenum stage) { program.stages.push_back({stage, nullptr}); }

void give_normal(Program& program) {
  program.fields.push_back({.name = "normal", .type = GL_FLOAT_VEC3, .role = capture::Role::normal, .words = 3});
}

TEST(DepthChoice, TheCurrentTagIsRounded) {
  EXPECT_EQ(level_of_tag(2.4), 2U);
  EXPECT_EQ(level_of_tag(2.5), 3U);
  EXPECT_EQ(level_of_tag(0.49999997), 0U);
}

TEST(DepthChoice, TheCurrentTagEndsAtZeroAndAtThePool) {
  EXPECT_EQ(level_of_tag(-3), 0U);
  EXPECT_EQ(level_of_tag(100), 6U);
  EXPECT_EQ(level_of_tag(NAN), 0U);
  EXPECT_EQ(level_of_tag(HUGE_VAL), 6U);
}

TEST(DepthChoice, TagsThatVaryMakeTheDrawAdaptive) {
  const ContextOptions options;
  const ArkState ark = with_tags();
  const depth::DepthPlan plan = choose_depths({.options = options, .ark = ark, .tags_vary = true, .current_tag = 3});
  EXPECT_TRUE(plan.adaptive);
  EXPECT_FALSE(plan.measured);
  EXPECT_EQ(plan.level, 0U);
  EXPECT_EQ(plan.deepest, 6U);
  EXPECT_TRUE(plan.keeps_instances());
}

TEST(DepthChoice, MorphingDrawsDoNotBecomeUniform) {
  const ContextOptions options;
  ArkState ark = with_tags();
  ark.geomorph = true;
  const depth::DepthPlan moving = choose_depths({.options = options, .ark = ark, .current_tag = 0.25});
  EXPECT_TRUE(moving.adaptive && moving.morphing);
  EXPECT_EQ(moving.interior, pattern::Interior::morphing);
  EXPECT_FALSE(choose_depths({.options = options, .ark = ark, .current_tag = 0}).adaptive);
  EXPECT_FALSE(choose_depths({.options = options, .ark = ark, .current_tag = NAN}).adaptive);
}

TEST(DepthChoice, AUniformLevelIgnoresTags) {
  const ContextOptions options;
  ArkState ark = with_tags();
  ark.depth_source = DepthSource::uniform;
  ark.uniform_level = 4;
  const DepthFacts facts{.options = options, .ark = ark, .tags_vary = true, .current_tag = 5};
  EXPECT_FALSE(takes_tags(facts));
  EXPECT_FALSE(choose_depths(facts).adaptive);
  EXPECT_EQ(choose_depths(facts).level, 4U);
}

TEST(DepthChoice, WhereNoMeasureAppliesTheUniformLevelHolds) {
  const ContextOptions options;
  ArkState ark = with_tags();
  ark.depth_source = DepthSource::measured;
  ark.uniform_level = 2;
  EXPECT_EQ(choose_depths({.options = options, .ark = ark}).level, 2U);
}

TEST(DepthChoice, TransparentRefinementHasTheUsersLevel) {
  const ContextOptions options{.transparent = true, .level = 3};
  const ArkState ark;
  EXPECT_FALSE(takes_tags({.options = options, .ark = ark}));
  EXPECT_EQ(choose_depths({.options = options, .ark = ark, .tags_vary = true}).level, 3U);
}

TEST(DepthChoice, MeasuredDrawsReachThePool) {
  const ContextOptions transparent{.transparent = true, .max_level = 7, .measure = {.pixels = 5}};
  const ContextOptions told;
  ArkState ark = with_tags(5);
  ark.depth_source = DepthSource::measured;
  const depth::DepthPlan users = choose_depths({.options = transparent, .ark = ark, .measurable = true});
  EXPECT_TRUE(users.adaptive && users.measured);
  EXPECT_EQ(users.deepest, 7U);
  EXPECT_EQ(users.measure.pixels, 5.0F);
  EXPECT_FALSE(users.keeps_instances());
  EXPECT_EQ(choose_depths({.options = told, .ark = ark, .measurable = true}).deepest, 5U);
}

TEST(DepthChoice, CoarseDrawsHaveDepthZero) {
  const ContextOptions options;
  const ArkState ark = with_tags();
  const depth::DepthPlan plan = choose_depths({.options = options, .ark = ark, .current_tag = 3, .coarse = true});
  EXPECT_TRUE(plan.coarse);
  EXPECT_EQ(plan.level, 0U);
  EXPECT_EQ(plan.deepest, 0U);
}

TEST(DepthChoice, TheInteriorIsTheApplications) {
  const ContextOptions options;
  ArkState ark = with_tags();
  EXPECT_EQ(choose_depths({.options = options, .ark = ark}).interior, pattern::Interior::minimum);
  ark.smooth_interior = true;
  EXPECT_EQ(choose_depths({.options = options, .ark = ark}).interior, pattern::Interior::smooth);
}

TEST(DepthChoice, TheMeasureIsTheUsersOrTheApplications) {
  const ContextOptions transparent{.transparent = true, .measure = {.pixels = 5}};
  const ContextOptions told{.measure = {.pixels = 5}};
  ArkState ark = with_tags();
  ark.measure = {.pixels = 9};
  EXPECT_EQ(edge_measure(transparent, ark).pixels, 5.0F);
  EXPECT_FALSE(edge_measure(told, ark).on());
  ark.depth_source = DepthSource::measured;
  EXPECT_EQ(edge_measure(told, ark).pixels, 9.0F);
}

TEST(DepthChoice, TheScreenIsMeasuredBeforeNoGeometryShader) {
  Program program;
  give_stage(program, GL_VERTEX_SHADER);
  EXPECT_TRUE(can_measure({.pixels = 8}, program, nullptr, false));
  give_stage(program, GL_GEOMETRY_SHADER);
  EXPECT_FALSE(can_measure({.pixels = 8}, program, nullptr, false));
}

TEST(DepthChoice, NormalsAreMeasuredWhereThereAreAny) {
  Program program;
  EXPECT_FALSE(can_measure({.degrees = 20}, program, nullptr, false));
  give_normal(program);
  EXPECT_TRUE(can_measure({.degrees = 20}, program, nullptr, false));
  EXPECT_FALSE(can_measure({}, program, nullptr, false));
}

TEST(DepthChoice, ProgramsThatChooseSubroutinesAreNotMeasured) {
  const Program program;
  EXPECT_FALSE(can_measure({.pixels = 8}, program, nullptr, true));
}

}  // namespace
}  // namespace glark::core
