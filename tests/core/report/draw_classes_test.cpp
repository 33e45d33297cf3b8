// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/draw_classes.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

// The tables are those of the process, and each test is a process of its own.
struct Totals {
  std::size_t classes = 0;
  std::uint64_t draws = 0;
  std::uint64_t triangles = 0;
  std::uint64_t frames = 0;
  std::uint64_t others = 0;
};

Totals totals() {
  Totals all;
  for_each_draw_class([&](const DrawClassKey* key, const DrawClassCounters& counters) {
    all.classes += key != nullptr ? 1 : 0;
    all.others += key == nullptr ? counters.draws.load() : 0;
    all.draws += counters.draws;
    all.triangles += counters.triangles;
    all.frames += counters.frames;
  });
  return all;
}

}  // namespace

TEST(DrawClasses, DrawsTrianglesAndFramesAreCounted) {
  DrawClasses classes;
  DrawClassKey key;
  key.verdict.cause = Cause::blended;
  classes.count(key, 10);
  classes.count(key, 5);
  classes.frame_finished();
  classes.count(key, 1);
  DrawClasses of_another_context;
  of_another_context.count(key, 4);
  const Totals all = totals();
  EXPECT_EQ(all.classes, 1u);
  EXPECT_EQ(all.draws, 4u);
  EXPECT_EQ(all.triangles, 20u);
  EXPECT_EQ(all.frames, 3u);
}

TEST(DrawClasses, AnotherStateOrVerdictIsAnotherClass) {
  DrawClasses classes;
  classes.count({}, 1);
  classes.count({.state = {.depth_only = true}}, 1);
  DrawClassKey fallen;
  fallen.verdict.fallback = RefinementFallback::no_normal;
  classes.count(fallen, 1);
  EXPECT_EQ(totals().classes, 3u);
}

TEST(DrawClasses, TheirNumberIsBounded) {
  DrawClasses classes;
  for (unsigned i = 0; i < most_draw_classes + 100; ++i) classes.count({.state = {.program = i}}, 1);
  const Totals all = totals();
  EXPECT_EQ(all.classes, most_draw_classes);
  EXPECT_EQ(all.others, 100u);
  EXPECT_EQ(all.draws, most_draw_classes + 100u);
}

}  // namespace glark::core
