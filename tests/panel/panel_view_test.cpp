// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sends the panel a user's keys and clicks. Dear ImGui checks its callers with assertions.
#include "shim/panel/view/panel_view.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <random>

#include "shim/panel/view/assertions.h"
#include "shim/panel/view/panel_input.h"

namespace glark::shim {
namespace {

using Kind = InputEvent::Kind;

core::WatchedClass class_with(std::optional<core::Cause> cause) {
  core::WatchedClass draws;
  draws.key.state.program = 7;
  draws.key.verdict.cause = cause;
  draws.draws = 3;
  draws.triangles = 1000;
  return draws;
}

class PanelView : public testing::Test {
 protected:
  PanelView() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    ImGui::GetIO().DeltaTime = 0.01F;
    PanelInput::start();
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    model_.title = "glark: test";
  }
  ~PanelView() override { ImGui::DestroyContext(); }

  PanelAnswer frame(float width = 700, float height = 700) {
    PanelAnswer answer;
    ImGui::GetIO().DisplaySize = ImVec2(width, height);
    const bool survived = survives_assertions([&] {
      input_.feed();
      ImGui::NewFrame();
      answer = show_panel(model_);
      ImGui::Render();
    });
    if (!survived) ADD_FAILURE() << failed_assertion();
    return answer;
  }
  void click(float x, float y) {
    input_.add({.kind = Kind::button, .down = true, .x = x, .y = y});
    input_.add({.kind = Kind::button, .down = false, .x = x, .y = y});
  }

  PanelModel model_;
  PanelInput input_;
};

TEST_F(PanelView, TheFirstBoxPausesRefinement) {
  frame();
  const PanelAnswer untouched = frame();
  EXPECT_FALSE(untouched.options_changed);
  click(28, 44);
  bool changed = false;
  for (int i = 0; i < 4; ++i) changed = frame().options_changed || changed;
  EXPECT_TRUE(changed);
  EXPECT_TRUE(model_.options.live.paused);
}

// The place of a button that adds to a number follows the lines above it, so each line is clicked.
TEST_F(PanelView, TheBudgetIsThereWithoutAMeasure) {
  frame();
  for (float y = 40; y < 300 && model_.options.measure.budget == 0; y += 8) {
    model_.options = {};
    click(198, y);
    for (int i = 0; i < 4; ++i) frame();
    ASSERT_FALSE(model_.options.measure.budget > 0 && model_.options.measure.on());
  }
  EXPECT_EQ(model_.options.measure.budget, 50000U);
}

TEST_F(PanelView, AClickBesideThePanelPicksAPixel) {
  model_.picking = true;
  frame();
  click(600, 650);
  std::optional<std::array<int, 2>> picked;
  for (int i = 0; i < 4; ++i)
    if (const PanelAnswer answer = frame(); answer.picked) picked = answer.picked;
  ASSERT_TRUE(picked);
  EXPECT_EQ(*picked, (std::array{600, 49})) << "rows count from below";
}

TEST_F(PanelView, FitsIntoTinyWindows) {
  for (const float side : {1.0F, 5.0F, 50.0F, 300.0F, 20000.0F}) {
    frame(side, side);
    const PanelAnswer answer = frame(side, side);
    EXPECT_GE(answer.area.width, 1);
    EXPECT_GE(answer.area.height, 1);
  }
}

// Options that the user cannot choose otherwise stay within their limits, whatever is clicked and typed.
TEST_F(PanelView, AnyKeysAndClicksLeaveValidOptions) {
  for (const core::Cause cause : {core::Cause::rule, core::Cause::screen_quad})
    model_.classes.push_back(class_with(cause));
  for (int i = 0; i < 200; ++i) model_.classes.push_back(class_with(std::nullopt));
  std::mt19937 random(7);
  const auto below = [&](unsigned count) { return static_cast<unsigned>(random() % count); };
  for (int i = 0; i < 3000; ++i) {
    const InputEvent events[] = {
        {.kind = Kind::move, .x = static_cast<float>(below(420)), .y = static_cast<float>(below(690))},
        {.kind = Kind::button,
         .down = below(2) == 0,
         .x = static_cast<float>(below(420)),
         .y = static_cast<float>(below(690)),
         .number = below(3)},
        {.kind = Kind::wheel, .y = static_cast<float>(below(5)) - 2},
        {.kind = Kind::key, .down = below(2) == 0, .number = below(14)},
        {.kind = Kind::character, .number = 32 + below(95)},
        {.kind = Kind::leave}};
    input_.add(events[below(6)]);
    const PanelAnswer answer = frame(700, static_cast<float>(600 + below(100)));
    if (answer.wants_pick) model_.picking = true;
    if (testing::Test::HasFailure()) break;
    const core::ContextOptions& options = model_.options;
    ASSERT_LE(options.level, core::max_supported_level);
    ASSERT_LE(options.level, options.max_level);
    ASSERT_GE(options.crease, 0);
    ASSERT_LE(options.crease, 180);
    ASSERT_GE(options.measure.pixels, 0);
    ASSERT_LE(options.measure.budget, 1000000000U);
  }
}

}  // namespace
}  // namespace glark::shim
