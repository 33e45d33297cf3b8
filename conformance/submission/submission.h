// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A submission: a .tar.gz of a report, with versions and checksums, for someone else to check.
#pragma once

#include <string>
#include <vector>

namespace glark::conformance {

// Of the suite: the version of the must-pass list, which changes whenever a case is added, removed or renamed.
inline constexpr int must_pass_version = 1;
// The names of that list (mustpass/1.txt): what an implementation has to pass.
const std::vector<std::string>& must_pass();

// Puts the report in `directory` into `archive`, with SHA256SUMS. Throws std::runtime_error; no half archive is left.
void package(const std::string& directory, const std::string& archive);

// What is wrong with the archive: a sum that does not match, a case of the must-pass list that is missing or did not pass, ...
// Empty where it stands. Throws std::runtime_error where it cannot be read.
std::vector<std::string> verify(const std::string& archive);

}  // namespace glark::conformance
