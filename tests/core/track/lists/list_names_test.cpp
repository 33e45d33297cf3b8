// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The names that glCallLists gives (OpenGL 4.6 compatibility, 21.4).
#include "glark/core/track/lists/list_names.h"

#include <array>

#include <gtest/gtest.h>

namespace glark::core::track {
namespace {

TEST(ListNames, GroupsOfBytesAreBigEndian) {
  const std::array<GLubyte, 8> bytes{0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(name_at(GL_2_BYTES, bytes.data(), 1), 0x0203U);
  EXPECT_EQ(name_at(GL_3_BYTES, bytes.data(), 1), 0x030405U);
  EXPECT_EQ(name_at(GL_4_BYTES, bytes.data(), 1), 0x04050607U);
}

TEST(ListNames, SignedNamesWrap) {
  const std::array<GLbyte, 2> bytes{1, -1};
  EXPECT_EQ(name_at(GL_BYTE, bytes.data(), 0), 1U);
  EXPECT_EQ(name_at(GL_BYTE, bytes.data(), 1), 0xffffffffU);
}

TEST(ListNames, FloatsAreCut) {
  const std::array<GLfloat, 1> floats{7.75F};
  EXPECT_EQ(name_at(GL_FLOAT, floats.data(), 0), 7U);
}

TEST(ListNames, OtherTypesAreRefused) {
  EXPECT_TRUE(is_name_type(GL_BYTE));
  EXPECT_TRUE(is_name_type(GL_4_BYTES));
  EXPECT_FALSE(is_name_type(GL_DOUBLE));
  EXPECT_FALSE(is_name_type(GL_BYTE - 1));
}

}  // namespace
}  // namespace glark::core::track
