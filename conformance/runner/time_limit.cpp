// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/runner/time_limit.h"

#include <fmt/core.h>

namespace glark::conformance {
namespace {

// A process that gets less of a processor than this share has stopped, however loaded the machine is.
constexpr double least_share = 0.01;

}  // namespace

std::optional<std::string> TimeLimit::exceeded(const TimeUsed& now) {
  if (now.clock - began_.clock > seconds_ && now.processor - began_.processor > seconds_)
    return fmt::format("no result after {} s of processor time", seconds_);
  if (now.clock - mark_.clock <= seconds_) return std::nullopt;
  if (now.processor - mark_.processor < least_share * seconds_)
    return fmt::format("no result, and nothing computed for {} s", seconds_);
  mark_ = now;
  return std::nullopt;
}

}  // namespace glark::conformance
