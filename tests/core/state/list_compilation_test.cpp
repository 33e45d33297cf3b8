// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The record of a display list that is being compiled.
#include "glark/core/state/lists/list_compilation.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

constexpr GLuint name = 5;

TEST(ListCompilation, SegmentsTakeTheEffectsOfTheirCalls) {
  ListCompilation lists;
  lists.begin(name, GL_COMPILE, true);
  lists.open_segment(100);
  lists.effects().touches_state = true;
  lists.note_uniforms();
  lists.close_segment({}, 1);
  lists.open_segment(101);
  lists.close_segment({.kind = ListSegment::Kind::draw}, 2);
  const std::shared_ptr<DisplayList> list = lists.end();
  ASSERT_EQ(list->segments.size(), 2U);
  EXPECT_EQ(list->segments[0].list, 100U);
  EXPECT_TRUE(list->segments[0].effects.touches_state);
  EXPECT_TRUE(list->segments[0].effects.changes_uniforms);
  EXPECT_FALSE(list->segments[1].effects.touches_state);
  EXPECT_TRUE(list->refinable);
  EXPECT_TRUE(list->changes_uniforms);
  EXPECT_FALSE(lists.compiling());
}

TEST(ListCompilation, UncutListsAreNotRefined) {
  ListCompilation lists;
  lists.begin(name, GL_COMPILE, false);
  lists.note_uniforms();
  const std::shared_ptr<DisplayList> list = lists.end();
  EXPECT_FALSE(list->refinable);
  EXPECT_TRUE(list->changes_uniforms);
}

TEST(ListCompilation, OpenGlBeginMakesTheListUnrefinable) {
  ListCompilation lists;
  lists.begin(name, GL_COMPILE, true);
  lists.primitive().begin(GL_TRIANGLES, true);
  EXPECT_FALSE(lists.end()->refinable);
}

TEST(ListCompilation, NothingIsPushedBetweenGlBeginAndGlEnd) {
  ListCompilation lists;
  EXPECT_FALSE(lists.add_stack_step({StackStep::Kind::pop}));
  lists.begin(name, GL_COMPILE, true);
  lists.primitive().begin(GL_TRIANGLES, true);
  EXPECT_FALSE(lists.add_stack_step({StackStep::Kind::pop}));
  EXPECT_TRUE(lists.primitive().end());
  EXPECT_TRUE(lists.add_stack_step({StackStep::Kind::pop}));
}

TEST(ListCompilation, LooseVerticesAreThoseOutsideGlBegin) {
  ListCompilation lists;
  lists.begin(name, GL_COMPILE, true);
  lists.add_loose_vertices(2);
  lists.primitive().begin(GL_TRIANGLES, true);
  lists.add_loose_vertices(3);
  EXPECT_EQ(lists.end()->loose_vertices, 2U);
}

}  // namespace
}  // namespace glark::core
