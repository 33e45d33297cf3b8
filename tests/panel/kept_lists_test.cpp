// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/kept_lists.h"

#include <gtest/gtest.h>

namespace glark::shim {
namespace {

class KeptListsTest : public testing::Test {
 protected:
  KeptListsTest() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = ImVec2(200, 100);
    ImGui::GetIO().DeltaTime = 0.01F;
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~KeptListsTest() override { ImGui::DestroyContext(); }

  // Returns whether the lists of a frame with this rectangle are new.
  bool draws_new(ImVec2 from, ImVec2 to, ImU32 color = IM_COL32_WHITE) {
    ImGui::NewFrame();
    ImGui::GetForegroundDrawList()->AddRectFilled(from, to, color);
    ImGui::Render();
    return lists_.update(*ImGui::GetDrawData());
  }

  KeptLists lists_;
};

TEST_F(KeptListsTest, TheSameFrameIsNotNew) {
  EXPECT_TRUE(draws_new({10, 20}, {50, 60}));
  EXPECT_FALSE(draws_new({10, 20}, {50, 60}));
}

TEST_F(KeptListsTest, AnotherPlaceOrColourIsNew) {
  draws_new({10, 20}, {50, 60});
  EXPECT_TRUE(draws_new({10, 20}, {50, 61}));
  EXPECT_TRUE(draws_new({10, 20}, {50, 61}, IM_COL32_BLACK));
}

TEST_F(KeptListsTest, TheAreaContainsWhatIsDrawn) {
  draws_new({10, 20}, {50, 60});
  const Area area = lists_.area();
  EXPECT_LE(area.x, 10);
  EXPECT_LE(area.y, 20);
  EXPECT_GE(area.x + area.width, 50);
  EXPECT_GE(area.y + area.height, 60);
  EXPECT_LE(area.width, 44) << "one pixel on each side for smooth edges, and rounding";
}

TEST_F(KeptListsTest, TheAreaEndsAtTheWindow) {
  draws_new({-50, -50}, {500, 500});
  EXPECT_EQ(lists_.area(), (Area{0, 0, 200, 100}));
}

TEST_F(KeptListsTest, NothingHasNoArea) {
  draws_new({300, 300}, {400, 400});
  EXPECT_EQ(lists_.area(), Area{});
}

}  // namespace
}  // namespace glark::shim
