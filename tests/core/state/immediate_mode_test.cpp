// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The counts between glBegin and glEnd.
#include "glark/core/state/immediate_mode.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

void count(ImmediateMode& immediate, int vertices) {
  for (int i = 0; i < vertices; ++i) immediate.count(3);
}

TEST(ImmediateMode, NestedBeginIsRefused) {
  ImmediateMode immediate;
  EXPECT_TRUE(immediate.begin(GL_TRIANGLES));
  EXPECT_FALSE(immediate.begin(GL_QUADS));
  EXPECT_EQ(immediate.mode(), static_cast<GLenum>(GL_TRIANGLES));
}

TEST(ImmediateMode, EndTellsWhetherACaptureEnds) {
  ImmediateMode immediate;
  immediate.begin(GL_TRIANGLES);
  immediate.capture(6);
  EXPECT_TRUE(immediate.end());
  immediate.begin(GL_TRIANGLES);
  EXPECT_FALSE(immediate.end());
}

TEST(ImmediateMode, CaptureIsFullAtItsLimit) {
  ImmediateMode immediate;
  immediate.begin(GL_TRIANGLES);
  immediate.capture(3);
  count(immediate, 2);
  EXPECT_FALSE(immediate.full());
  count(immediate, 1);
  EXPECT_TRUE(immediate.full());
}

TEST(ImmediateMode, WithoutACaptureNothingIsFull) {
  ImmediateMode immediate;
  immediate.begin(GL_TRIANGLES);
  immediate.capture(0);
  EXPECT_FALSE(immediate.full());
  EXPECT_FALSE(immediate.end());
}

// Seven vertices are two whole triangles and one vertex that draws nothing: it takes no room.
TEST(ImmediateMode, RestartUsesUpTheRoomOfWholePrimitives) {
  ImmediateMode immediate;
  immediate.begin(GL_TRIANGLES);
  immediate.capture(9);
  count(immediate, 7);
  immediate.restart(2, 3);
  EXPECT_EQ(immediate.all_vertices(), 7U);
  EXPECT_EQ(immediate.triangles_before(), 2U);
  EXPECT_FALSE(immediate.before_vertices());
  count(immediate, 3);
  EXPECT_TRUE(immediate.full());
}

TEST(ImmediateMode, ComponentsAreBits) {
  ImmediateMode immediate;
  immediate.count(2);
  immediate.count(4);
  EXPECT_EQ(immediate.components(), 1U << 2 | 1U << 4);
  immediate.restart_counts();
  EXPECT_EQ(immediate.components(), 0U);
}

}  // namespace
}  // namespace glark::core
