// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/budget_choice.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

TEST(BudgetChoice, ItGoesToCurvesIfThereIsABudgetOfTheUser) {
  ContextOptions options{.transparent = true};
  ArkState ark;
  depth::DepthPlan depth;
  depth.measured = true;
  depth.measure = {.pixels = 8, .budget = 1000};
  const auto spends = [&](Refinement wanted = Refinement::pn) { return spends_on_curves(options, ark, wanted, depth); };
  EXPECT_TRUE(spends());
  EXPECT_FALSE(spends(Refinement::linear_inputs));
  ark.enabled = true;
  EXPECT_FALSE(spends()) << "the program calls the extension";
  ark.enabled = false;
  options.transparent = false;
  EXPECT_FALSE(spends());
  options.transparent = true;
  depth.measure.budget = 0;
  EXPECT_FALSE(spends());
  depth.measure.budget = 1000;
  depth.measured = false;
  EXPECT_FALSE(spends()) << "the level is uniform";
}

class Backgrounds : public testing::Test {
 protected:
  Backgrounds() {
    bindings_.depth_test = true;
    bindings_.depth_function = GL_LEQUAL;
    bindings_.depth_writes = false;
    bindings_.color_writes = true;
  }
  bool background() const {
    return is_background({.bindings = bindings_,
                          .depth_buffer = depth_buffer_,
                          .color_buffer = color_buffer_,
                          .others_write_depth = others_,
                          .mesh_writes_depth = mesh_});
  }
  Bindings bindings_;
  bool depth_buffer_ = true;
  bool color_buffer_ = true;
  bool others_ = true;
  bool mesh_ = false;
};

TEST_F(Backgrounds, WriteNoDepthWhileOthersDo) {
  EXPECT_TRUE(background());
  bindings_.depth_writes = true;
  EXPECT_FALSE(background());
  bindings_.depth_test = false;  // nothing is written without the test
  EXPECT_TRUE(background());
  others_ = false;
  EXPECT_FALSE(background()) << "the program draws back to front";
}

TEST_F(Backgrounds, AreNotBlended) {
  bindings_.blend = true;
  EXPECT_FALSE(background());
}

TEST_F(Backgrounds, DoNotMeetAnotherPass) {
  mesh_ = true;
  EXPECT_FALSE(background()) << "a light over a pre-pass";
  bindings_.depth_function = GL_ALWAYS;
  EXPECT_TRUE(background());
  mesh_ = false;
  bindings_.depth_function = GL_EQUAL;
  EXPECT_FALSE(background());
}

TEST_F(Backgrounds, HaveColors) {
  color_buffer_ = false;
  EXPECT_FALSE(background());
}

TEST_F(Backgrounds, AFramebufferWithoutDepthTestsNone) {
  depth_buffer_ = false;
  bindings_.depth_writes = true;
  EXPECT_TRUE(background());
}

}  // namespace
}  // namespace glark::core
