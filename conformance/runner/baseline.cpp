// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/baseline.h"

#include <stdexcept>

#include "conformance/runner/selection.h"

namespace glark::conformance {
namespace {

void apply(const Expectation& expectation, Record& record) {
  const bool passed = record.seen == Verdict::pass || record.seen == Verdict::quality_warning;
  if (expectation.verdict == Verdict::flake) {
    if (is_bad(record.seen)) record.verdict = Verdict::flake;
  } else if (passed) {
    record.verdict = Verdict::unexpected_pass;
  } else if (record.seen == expectation.verdict) {
    record.verdict = Verdict::expected_fail;
  }
}

}  // namespace

std::vector<Expectation> read_baseline(const std::string& path) {
  std::vector<Expectation> baseline;
  for (const std::string& line : read_list(path)) {
    const std::size_t comma = line.rfind(',');
    const auto verdict = comma == std::string::npos ? std::nullopt : verdict_of(line.substr(comma + 1));
    if (!verdict || (!is_bad(*verdict) && *verdict != Verdict::flake) || *verdict == Verdict::unexpected_pass)
      throw std::runtime_error(
          path + ": not NAME,VERDICT with Fail, Crash, Timeout, InternalError, Missing or Flake: " + line);
    baseline.push_back({line.substr(0, comma), *verdict});
  }
  return baseline;
}

void apply_baseline(const std::vector<Expectation>& baseline, std::vector<Record>& records) {
  for (Record& record : records) {
    for (const Expectation& expectation : baseline) {
      if (!matches(expectation.glob, record.name)) continue;
      apply(expectation, record);
      break;
    }
  }
}

}  // namespace glark::conformance
