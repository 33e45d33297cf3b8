// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/names/keys.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "glark/settings/settings.h"
#include "glark/settings/terminal.h"

namespace glark::settings {

TEST(Keys, AreFoundInUpperAndLowerCase) {
  ASSERT_NE(find_key("f10"), nullptr);
  EXPECT_EQ(find_key("F10")->keysym, 0xFFC7U);
  EXPECT_EQ(find_key("F10")->code, 68U);
  EXPECT_EQ(find_key("F"), nullptr);
  EXPECT_EQ(find_key(""), nullptr);
}

TEST(Keys, DifferFromEachOther) {
  std::set<std::uint32_t> keysyms;
  std::set<std::uint32_t> codes;
  for (const Key& key : known_keys()) {
    EXPECT_TRUE(keysyms.insert(key.keysym).second) << key.name;
    EXPECT_TRUE(codes.insert(key.code).second) << key.name;
  }
}

TEST(Keys, NoneIsAValue) {
  EXPECT_EQ(parse_key("none"), std::optional<const Key*>(nullptr));
  EXPECT_EQ(parse_key("F13"), std::nullopt);
  EXPECT_EQ((*parse_key("Pause"))->name, "Pause");
}

TEST(Terminal, NoColorIsKept) {
  const std::array<const char*, 2> plain{"TERM=xterm", nullptr};
  EXPECT_TRUE(allows_colors(plain.data()));
  const std::array<const char*, 3> refused{"TERM=xterm", "NO_COLOR=1", nullptr};
  EXPECT_FALSE(allows_colors(refused.data()));
  const std::array<const char*, 3> empty{"TERM=xterm", "NO_COLOR=", nullptr};
  EXPECT_TRUE(allows_colors(empty.data())) << "an empty variable counts as unset";
  const std::array<const char*, 2> dumb{"TERM=dumb", nullptr};
  EXPECT_FALSE(allows_colors(dumb.data()));
}

}  // namespace glark::settings
