// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/selection.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "conformance/runner/baseline.h"

namespace glark::conformance {
namespace {

const std::vector<std::string> all = {"ark.a.one", "ark.a.two", "ark.b.one", "ark.b.two"};

TEST(Selection, GlobsJoin) {
  EXPECT_EQ(select(all, {.globs = {"ark.a.*", "*.two"}}),
            (std::vector<std::string>{"ark.a.one", "ark.a.two", "ark.b.two"}));
}

TEST(Selection, ListAndGlobMeet) {
  EXPECT_EQ(select(all, {.globs = {"*.one"}, .names = {"ark.b.one", "ark.b.two"}, .has_list = true}),
            std::vector<std::string>{"ark.b.one"});
}

TEST(Selection, EmptyListSelectsNothing) { EXPECT_TRUE(select(all, {.has_list = true}).empty()); }

TEST(Selection, RejectsWhatMatchesNothing) {
  EXPECT_THROW(select(all, {.globs = {"ark.a.*", "ark.c.*"}}), std::invalid_argument);
  EXPECT_THROW(select(all, {.names = {"ark.c"}, .has_list = true}), std::invalid_argument);
}

Record record(Verdict seen) {
  Record result;
  result.name = "ark.a.one";
  result.verdict = result.seen = seen;
  return result;
}

Verdict judged(Verdict seen, Verdict expected) {
  std::vector<Record> records = {record(seen)};
  apply_baseline({{"ark.a.*", expected}, {"*", Verdict::crash}}, records);
  return records.front().verdict;
}

TEST(Baseline, KnownFailureIsExpected) { EXPECT_EQ(judged(Verdict::fail, Verdict::fail), Verdict::expected_fail); }
TEST(Baseline, AnotherFailureIsNot) { EXPECT_EQ(judged(Verdict::crash, Verdict::fail), Verdict::crash); }
TEST(Baseline, PassIsUnexpected) { EXPECT_EQ(judged(Verdict::pass, Verdict::fail), Verdict::unexpected_pass); }
TEST(Baseline, FlakeMayPass) {
  EXPECT_EQ(judged(Verdict::pass, Verdict::flake), Verdict::pass);
  EXPECT_EQ(judged(Verdict::timeout, Verdict::flake), Verdict::flake);
}
TEST(Baseline, NotSupportedStays) { EXPECT_EQ(judged(Verdict::not_supported, Verdict::fail), Verdict::not_supported); }

}  // namespace
}  // namespace glark::conformance
