// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/time_limit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glark::conformance {
namespace {

// Looks at a process five times a second. It computes for `share` of the time. Returns when the limit of 10 s ends it,
// or 1000 s.
double end_of(double share) {
  TimeLimit limit(10);
  limit.begin({.clock = 100, .processor = 7});
  for (int step = 0; step < 5000; ++step) {
    const double seconds = step / 5.0;
    if (limit.exceeded({.clock = 100 + seconds, .processor = 7 + share * seconds})) return seconds;
  }
  return 1000;
}

TEST(TimeLimit, OfAProcessThatOnlyComputes) { EXPECT_NEAR(end_of(1), 10, 0.5); }
TEST(TimeLimit, LoadLengthensIt) {
  EXPECT_NEAR(end_of(0.5), 20, 0.5);
  EXPECT_NEAR(end_of(0.05), 200, 0.5);
}
TEST(TimeLimit, ThreadsDoNotShortenIt) { EXPECT_NEAR(end_of(16), 10, 0.5); }
TEST(TimeLimit, ADeadlockEndsInTime) { EXPECT_NEAR(end_of(0), 10, 0.5); }

TEST(TimeLimit, ADeadlockAfterWorkEndsInTime) {
  TimeLimit limit(10);
  limit.begin({});
  double seconds = 0;
  while (seconds < 100 && !limit.exceeded({.clock = seconds, .processor = std::min(seconds, 3.0)})) seconds += 0.2;
  EXPECT_NEAR(seconds, 20, 0.5);
}

TEST(TimeLimit, EachCaseHasItsOwn) {
  TimeLimit limit(10);
  limit.begin({});
  EXPECT_FALSE(limit.exceeded({.clock = 9, .processor = 9}));
  limit.begin({.clock = 9, .processor = 9});
  EXPECT_FALSE(limit.exceeded({.clock = 18, .processor = 18}));
  EXPECT_TRUE(limit.exceeded({.clock = 20, .processor = 20}));
}

}  // namespace
}  // namespace glark::conformance
