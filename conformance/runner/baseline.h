// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What is known to fail, so that a run shows what changed. A line is "NAME,VERDICT  # reason", VERDICT being what the case
// comes to (Fail, Crash, Timeout, ...), or "NAME,Flake" for one that fails at times. NAME may be a glob.
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

// As expected: ExpectedFail; a pass in its place: UnexpectedPass; anything but a pass of a flake: Flake. Another failure than
// the expected one stays what it is.
void apply_baseline(const std::vector<Expectation>& baseline, std::vector<Record>& records);

}  // namespace glark::conformance
