// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/assertions.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <stdexcept>

namespace glark::shim {

TEST(Assertions, OneOfDearImGuiDoesNotEndTheProcess) {
  ImGui::CreateContext();
  bool went_on = false;
  EXPECT_FALSE(survives_assertions([&] {
    ImGui::NewFrame();  // the fonts are not built
    went_on = true;
  }));
  EXPECT_FALSE(went_on);
  EXPECT_NE(failed_assertion().find("imgui"), std::string::npos) << failed_assertion();
}

TEST(Assertions, CallsWithoutOnePassThrough) {
  int calls = 0;
  EXPECT_TRUE(survives_assertions([&] { ++calls; }));
  EXPECT_THROW(survives_assertions([&] {
                 ++calls;
                 throw std::runtime_error("passes");
               }),
               std::runtime_error);
  EXPECT_EQ(calls, 2);
}

TEST(AssertionsDeathTest, ThoseOfOthersStillEndTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  ImGui::SetCurrentContext(nullptr);
  EXPECT_DEATH(ImGui::NewFrame(), "GImGui");
}

}  // namespace glark::shim
