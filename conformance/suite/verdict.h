// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace glark::conformance {

// The result of a case. The case itself gives the first six. The runner gives crash, timeout and missing, by the way
// the process ends. A baseline gives the last three (runner/baseline.h).
enum class Verdict {
  pass,
  fail,             // the implementation does not do what the clause says
  not_supported,    // the clause does not concern this context, or there is no extension
  quality_warning,  // allowed, but worse than a good implementation
  unimplemented,    // the case is planned and not written
  internal_error,   // the case could not judge: its control failed, or the suite is at fault
  crash,
  timeout,
  missing,  // the case never reported an end; never a pass
  expected_fail,
  unexpected_pass,
  flake,
};

inline constexpr std::array<std::string_view, 12> verdict_names = {
    "Pass",  "Fail",    "NotSupported", "QualityWarning", "Unimplemented",  "InternalError",
    "Crash", "Timeout", "Missing",      "ExpectedFail",   "UnexpectedPass", "Flake"};

inline constexpr std::string_view name_of(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

inline constexpr std::optional<Verdict> verdict_of(std::string_view name) {
  for (std::size_t i = 0; i < verdict_names.size(); ++i)
    if (verdict_names[i] == name) return static_cast<Verdict>(i);
  return std::nullopt;
}

// Whether this verdict makes a whole run fail.
inline constexpr bool is_bad(Verdict verdict) {
  return verdict == Verdict::fail || verdict == Verdict::internal_error || verdict == Verdict::crash ||
         verdict == Verdict::timeout || verdict == Verdict::missing || verdict == Verdict::unexpected_pass;
}

}  // namespace glark::conformance
