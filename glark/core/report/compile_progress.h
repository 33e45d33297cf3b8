// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the user reads while glark compiles its shader programs. No GL, no clock.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "glark/core/report/log.h"

namespace glark::core {

struct ProgressLine {
  LogLevel level = LogLevel::info;
  std::string text;
};

class CompileProgress {
 public:
  // Notes a program that took `seconds`. `waiting`: programs that are known to be needed, too. Returns a line for the
  // first program, and after 1, 2, 4, 8 ... seconds in total.
  std::optional<ProgressLine> compiled(double seconds, std::size_t waiting);
  // Notes more time for programs that were compiled before: some drivers compile again at the first draw.
  void add(double seconds) { seconds_ += seconds; }
  // Nothing is compiled any more. Returns a line if something was.
  std::optional<ProgressLine> finished();

 private:
  std::size_t done_ = 0;
  double seconds_ = 0;
  double next_ = first_notice;

  static constexpr double first_notice = 1;  // second: a user notices such a wait
};

}  // namespace glark::core
