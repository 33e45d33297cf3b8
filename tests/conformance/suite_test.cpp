// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>

#include "conformance/report/report.h"
#include "conformance/suite/case.h"
#include "conformance/suite/picture.h"

namespace glark::conformance {
namespace {

TEST(Pictures, DifferenceCountsPixelsBeyondTolerance) {
  const Picture a(4, 4, {10, 10, 10, 255});
  Picture b = a;
  b.set(1, 2, {12, 10, 10, 255});
  b.set(3, 3, {10, 13, 10, 255});
  EXPECT_EQ(count_different(a, b, 0), 2);
  EXPECT_EQ(count_different(a, b, 2), 1);
  EXPECT_EQ(count_different(a, b, 3), 0);
}

TEST(Pictures, OtherSizeDiffersEverywhere) { EXPECT_EQ(count_different(Picture(4, 4), Picture(4, 5), 255), 20); }

TEST(Pictures, DifferenceShowsWhere) {
  const Picture a(2, 1, {30, 60, 90, 255});
  Picture b = a;
  b.set(1, 0, {0, 60, 90, 255});
  const Picture difference = difference_of(a, b, 0);
  EXPECT_EQ(difference.at(0, 0), (std::array<std::uint8_t, 4>{10, 20, 30, 255}));
  EXPECT_EQ(difference.at(1, 0), (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
}

TEST(Clauses, AreQuotedById) {
  EXPECT_EQ(sentence_of("10.R.1-1"), "Every vertex has a depth tag, an integer.");
  EXPECT_THROW(sentence_of("10.R.1-1000"), std::logic_error);
}

TEST(Reports, EscapeWhatXmlCannotHold) { EXPECT_EQ(escaped("a<b>&\"\x01\xFF"), "a&lt;b&gt;&amp;&quot;??"); }

TEST(Reports, ResultsAreReadBack) {
  Report report;
  report.environment["renderer"] = "r";
  Record record;
  record.name = "ark.x";
  record.verdict = Verdict::expected_fail;
  record.seen = Verdict::fail;
  record.messages = {"m\xFF"};
  report.records = {record};
  const Report again = parse_report(as_json(report), "name");
  ASSERT_EQ(again.records.size(), 1U);
  EXPECT_EQ(again.records[0].seen, Verdict::fail);
  EXPECT_EQ(again.environment.at("renderer"), "r");
}

TEST(Reports, BadResultsAreErrors) {
  for (const char* text : {"", "[]", "{}", R"({"format": "other"})",
                           R"({"format": "glark-conformance results 1", "environment": {}, "command": [], "seconds": 0,
                               "results": [{"name": "ark.x", "verdict": "Fine", "seen": "Fine"}]})"})
    EXPECT_THROW(parse_report(text, "name"), std::runtime_error) << text;
}

TEST(Reports, MissingIsBad) {
  EXPECT_TRUE(is_bad(Verdict::missing));
  EXPECT_FALSE(is_bad(Verdict::expected_fail));
}

}  // namespace
}  // namespace glark::conformance
