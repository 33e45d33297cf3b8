// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_ARK on the stack of glPushAttrib.
#include "glark/core/state/attribute_stack.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

TEST(AttributeStack, RestoresWhatTheEnableGroupSaved) {
  AttributeStack stack;
  stack.push(GL_ENABLE_BIT, true, 16);
  stack.push(GL_ENABLE_BIT | GL_CURRENT_BIT, false, 16);
  EXPECT_EQ(stack.pop(), std::optional(false));
  EXPECT_EQ(stack.pop(), std::optional(true));
}

TEST(AttributeStack, OtherGroupsSaveNothing) {
  AttributeStack stack;
  stack.push(GL_CURRENT_BIT, true, 16);
  EXPECT_EQ(stack.pop(), std::nullopt);
}

TEST(AttributeStack, FullStackTakesNothing) {
  AttributeStack stack;
  stack.push(GL_ENABLE_BIT, true, 1);
  stack.push(GL_ENABLE_BIT, false, 1);
  EXPECT_EQ(stack.pop(), std::optional(true));
  EXPECT_EQ(stack.pop(), std::nullopt);
}

}  // namespace
}  // namespace glark::core
