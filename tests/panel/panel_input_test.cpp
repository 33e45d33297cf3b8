// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/panel_input.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "glark/settings/names/keys.h"

namespace glark::shim {
namespace {

using Kind = InputEvent::Kind;

class PanelInputs : public testing::Test {
 protected:
  PanelInputs() {
    ImGui::CreateContext();
    ImGui::GetIO().DisplaySize = ImVec2(100, 100);
    ImGui::GetIO().DeltaTime = 0.01F;
    PanelInput::start();
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~PanelInputs() override { ImGui::DestroyContext(); }
  // Returns whether the left button was pressed in this frame.
  bool frame() {
    input_.feed();
    ImGui::NewFrame();
    const bool clicked = ImGui::IsMouseClicked(0);
    ImGui::EndFrame();
    return clicked;
  }

  PanelInput input_;
};

TEST_F(PanelInputs, APressAndItsReleaseInOneFrameAreAClick) {
  input_.add({.kind = Kind::button, .down = true, .x = 10, .y = 20});
  input_.add({.kind = Kind::button, .down = false, .x = 10, .y = 20});
  EXPECT_TRUE(frame());
  EXPECT_TRUE(ImGui::IsMouseDown(0));
  EXPECT_FALSE(frame());
  EXPECT_FALSE(ImGui::IsMouseDown(0));
}

TEST_F(PanelInputs, TheClickIsWhereThePointerWas) {
  input_.add({.kind = Kind::button, .down = true, .x = 10, .y = 20});
  input_.add({.kind = Kind::move, .x = 50, .y = 60});
  EXPECT_TRUE(frame());
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 10);
  frame();
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 50);
}

TEST_F(PanelInputs, APointerThatLeavesIsNowhere) {
  input_.add({.kind = Kind::move, .x = 50, .y = 60});
  input_.add({.kind = Kind::leave});
  frame();
  EXPECT_FALSE(ImGui::IsMousePosValid());
}

}  // namespace
}  // namespace glark::shim
