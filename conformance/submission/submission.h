// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A submission: a .tar.gz of a report with versions and checksums, for someone else to check.
#pragma once

#include <string>
#include <vector>

#include "conformance/suite/case.h"

namespace glark::conformance {

// The version of the must-pass list. It changes whenever a case is added, removed or renamed.
inline constexpr int must_pass_version = 1;
// A case of the must-pass list. In these APIs, NotSupported is no answer.
struct RequiredCase {
  std::string name;
  Apis apis;
};
// The must-pass list (mustpass/1.txt): the cases that an implementation has to pass.
const std::vector<RequiredCase>& must_pass();

// Packs the report in `directory` into `archive`, with SHA256SUMS. Throws std::runtime_error and then leaves no partial
// archive.
void package(const std::string& directory, const std::string& archive);

// Returns what is wrong with the archive: a sum that does not match, a case of the must-pass list that is missing, did
// not pass, or was not supported where it has to be, a verdict that contradicts what was seen, and so on. Empty if the archive is valid. Throws std::runtime_error if it cannot be read.
std::vector<std::string> verify(const std::string& archive);

}  // namespace glark::conformance
