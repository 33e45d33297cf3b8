// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/live/frame_watch.h"

#include <gtest/gtest.h>

#include "glark/core/live/half_window.h"

namespace glark::core {
namespace {

DrawClassKey draws_of(std::uint64_t program, std::optional<Cause> cause = {}) {
  DrawClassKey key;
  key.state.program = program;
  key.verdict.cause = cause;
  return key;
}

}  // namespace

TEST(FrameWatch, ShowsTheClassesOfTheLastFrameOnly) {
  FrameWatch watch;
  watch.count(draws_of(1), false, 10);
  EXPECT_TRUE(watch.last_frame().empty());
  watch.frame_finished();
  watch.count(draws_of(2), false, 5);
  ASSERT_EQ(watch.last_frame().size(), 1U);
  EXPECT_EQ(watch.last_frame()[0].key.state.program, 1U);
  watch.frame_finished();
  ASSERT_EQ(watch.last_frame().size(), 1U);
  EXPECT_EQ(watch.last_frame()[0].key.state.program, 2U);
}

TEST(FrameWatch, SumsAClassAndPutsTheLargestFirst) {
  FrameWatch watch;
  watch.count(draws_of(1), false, 10);
  watch.count(draws_of(2), false, 15);
  watch.count(draws_of(1), false, 10);
  watch.count(draws_of(1), true, 1);  // the same state, but refined earlier
  watch.frame_finished();
  ASSERT_EQ(watch.last_frame().size(), 3U);
  EXPECT_EQ(watch.last_frame()[0].draws, 2U);
  EXPECT_EQ(watch.last_frame()[0].triangles, 20U);
  EXPECT_EQ(watch.last_frame()[2].group(), DrawGroup::kept);
}

TEST(FrameWatch, TheLastChangeOfThePixelCounts) {
  FrameWatch watch;
  watch.changed_pixel(draws_of(1), false);
  watch.changed_pixel(draws_of(2), false);
  watch.changed_pixel(draws_of(1), false);
  watch.frame_finished();
  for (const WatchedClass& draws : watch.last_frame())
    EXPECT_EQ(draws.pixel_step, draws.key.state.program == 1 ? 3U : 2U);
}

TEST(FrameWatch, TooManyClassesCountAsTheLastOne) {
  FrameWatch watch;
  for (std::uint64_t program = 1; program <= FrameWatch::most_classes + 5; ++program)
    watch.count(draws_of(program), false, 1);
  watch.frame_finished();
  EXPECT_EQ(watch.last_frame().size(), FrameWatch::most_classes);
  EXPECT_EQ(watch.last_frame()[0].draws, 6U);
}

TEST(DrawGroups, EachCauseHasOne) {
  EXPECT_EQ(group_of(draws_of(1).verdict, false), DrawGroup::refined);
  EXPECT_EQ(group_of(draws_of(1, Cause::compiling).verdict, false), DrawGroup::waits);
  EXPECT_EQ(group_of(draws_of(1, Cause::mesh_flat).verdict, false), DrawGroup::flat);
  EXPECT_EQ(group_of(draws_of(1, Cause::overlay).verdict, false), DrawGroup::interface);
  EXPECT_EQ(group_of(draws_of(1, Cause::rule).verdict, false), DrawGroup::user);
  EXPECT_EQ(group_of(draws_of(1, Cause::polygon_mode).verdict, false), DrawGroup::impossible);
}

TEST(HalfWindow, TheHalvesOfABoxMeetAtTheMiddle) {
  const Box box{10, 5, 80, 40};
  EXPECT_EQ(left_of(box, 30), (Box{10, 5, 20, 40}));
  EXPECT_EQ(right_of(box, 30), (Box{30, 5, 60, 40}));
}

TEST(HalfWindow, ABoxOnOneSideHasAnEmptyHalf) {
  const Box box{10, 5, 80, 40};
  EXPECT_EQ(left_of(box, 5), (Box{10, 5, 0, 40}));
  EXPECT_EQ(right_of(box, 5), box);
  EXPECT_EQ(left_of(box, 95), box);
  EXPECT_EQ(right_of(box, 95), (Box{90, 5, 0, 40}));
}

}  // namespace glark::core
