// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Known failures, so that a run shows what changed. A line is "NAME,VERDICT  # reason", or "NAME,Flake" if the case
// fails at times. VERDICT is the case's usual result (Fail, Crash, Timeout, ...). NAME may be a glob.
#pragma once

#include <string>
#include <vector>

#include "conformance/report/record.h"

namespace glark::conformance {

struct Expectation {
  std::string glob;
  Verdict verdict;
};

// Throws std::runtime_error with file and line.
std::vector<Expectation> read_baseline(const std::string& path);

// An expected failure becomes ExpectedFail, a pass instead of it UnexpectedPass, and any failure of a flake Flake. A
// failure other than the expected one stays as it is.
void apply_baseline(const std::vector<Expectation>& baseline, std::vector<Record>& records);

}  // namespace glark::conformance
