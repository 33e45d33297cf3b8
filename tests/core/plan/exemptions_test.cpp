// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/unrefined/exemptions.h"

#include <gtest/gtest.h>

#include "glark/core/context_options.h"

namespace glark::core {
namespace {

Bindings without_depth(bool blend = false) {
  Bindings bindings;
  bindings.depth_test = false;
  bindings.blend = blend;
  return bindings;
}

Bindings with_depth(GLenum function = GL_LESS, bool writes = true) {
  Bindings bindings;
  bindings.depth_test = true;
  bindings.depth_function = function;
  bindings.depth_writes = writes;
  return bindings;
}

std::optional<Cause> by_default(const Bindings& bindings, std::uint64_t triangles) {
  return exemption({.rules = left_draws::by_default, .bindings = bindings, .triangles = triangles});
}

TEST(ExemptionRules, TwoTrianglesWithoutDepthAreAScreenQuad) {
  EXPECT_EQ(by_default(without_depth(), 2), Cause::screen_quad);
  EXPECT_EQ(by_default(with_depth(GL_ALWAYS, false), 1), Cause::screen_quad);
  EXPECT_EQ(by_default(without_depth(), 3), std::nullopt);
}

TEST(ExemptionRules, WithoutADepthBufferTheDepthTestIsOff) {
  const Bindings bindings = with_depth();
  ExemptionFacts facts{.rules = left_draws::by_default, .bindings = bindings, .depth_buffer = false, .triangles = 2};
  EXPECT_EQ(exemption(facts), Cause::screen_quad);
  facts.rules = left_draws::no_depth_test;
  EXPECT_EQ(exemption(facts), Cause::no_depth_test);
  facts.rules = left_draws::no_depth_writes;
  EXPECT_EQ(exemption(facts), Cause::no_depth_writes);
  facts.depth_buffer = true;
  EXPECT_EQ(exemption(facts), std::nullopt);
}

TEST(ExemptionRules, TrianglesThatAreNotCountedYetAreNoScreenQuad) {
  EXPECT_EQ(by_default(without_depth(), 0), std::nullopt);
}

TEST(ExemptionRules, PassesThatMeetByDepthAreRefined) {
  EXPECT_EQ(by_default(with_depth(GL_EQUAL, false), 2), std::nullopt);
  EXPECT_EQ(by_default(with_depth(GL_ALWAYS, true), 2), std::nullopt);
}

TEST(ExemptionRules, BlendingWithoutDepthIsAnOverlay) {
  EXPECT_EQ(by_default(without_depth(true), 100), Cause::overlay);
}

TEST(ExemptionRules, APerspectiveProjectionIsNoInterface) {
  constexpr unsigned rules = left_draws::by_default;
  const Bindings bindings = without_depth(true);
  const ExemptionFacts perspective{.rules = rules, .bindings = bindings, .conventional = true, .triangles = 2};
  EXPECT_EQ(exemption(perspective), std::nullopt);
  const ExemptionFacts affine{
      .rules = rules, .bindings = bindings, .conventional = true, .triangles = 2, .matrices = {.affine = true}};
  EXPECT_EQ(exemption(affine), Cause::screen_quad);
}

TEST(ExemptionRules, DrawingsInThePlaneAreLeftWithDepthToo) {
  const Bindings bindings = with_depth();
  const ExemptionFacts plane{.rules = left_draws::by_default,
                             .bindings = bindings,
                             .conventional = true,
                             .matrices = {.affine = true, .projects_plane = true, .moves_in_plane = true}};
  EXPECT_EQ(exemption(plane), Cause::orthographic);
  const ExemptionFacts turned{.rules = left_draws::by_default,
                              .bindings = bindings,
                              .conventional = true,
                              .matrices = {.affine = true, .projects_plane = true}};
  EXPECT_EQ(exemption(turned), std::nullopt);
}

TEST(ExemptionRules, TheUserNamesDraws) {
  const Bindings blended = without_depth(true);
  EXPECT_EQ(exemption({.rules = left_draws::blended, .bindings = blended}), Cause::blended);
  EXPECT_EQ(exemption({.rules = left_draws::no_depth_test, .bindings = blended}), Cause::no_depth_test);
  EXPECT_EQ(exemption({.rules = left_draws::no_depth_writes, .bindings = blended}), Cause::no_depth_writes);
  const Bindings reading = with_depth(GL_LESS, false);
  EXPECT_EQ(exemption({.rules = left_draws::no_depth_writes, .bindings = reading}), Cause::no_depth_writes);
  EXPECT_EQ(exemption({.rules = 0, .bindings = reading, .left_alone = true}), Cause::left_shader);
}

TEST(ExemptionRules, MatricesAreAskedForOnlyWhereTheyCount) {
  const Bindings ignoring = without_depth();
  const Bindings testing = with_depth();
  EXPECT_FALSE(needs_matrices({.rules = left_draws::by_default, .bindings = ignoring}));
  EXPECT_TRUE(needs_matrices({.rules = left_draws::orthographic, .bindings = testing, .conventional = true}));
  EXPECT_FALSE(needs_matrices({.rules = left_draws::overlays, .bindings = testing, .conventional = true}));
  EXPECT_TRUE(needs_matrices({.rules = left_draws::overlays, .bindings = ignoring, .conventional = true}));
  EXPECT_FALSE(needs_matrices(
      {.rules = left_draws::orthographic, .bindings = testing, .left_alone = true, .conventional = true}));
}

}  // namespace
}  // namespace glark::core
