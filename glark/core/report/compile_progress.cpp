// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/compile_progress.h"

#include <fmt/format.h>

#include <utility>

namespace glark::core {

std::optional<ProgressLine> CompileProgress::compiled(double seconds, std::size_t waiting) {
  ++done_;
  seconds_ += seconds;
  const bool long_wait = seconds_ >= next_;
  if (!long_wait && done_ > 1) {
    return std::nullopt;
  }
  while (seconds_ >= next_) {
    next_ *= 2;
  }
  return ProgressLine{long_wait ? LogLevel::progress : LogLevel::info,
                      fmt::format("compiling {} of {} shader programs for refined draws, {:.1f} s so far", done_,
                                  done_ + waiting, seconds_)};
}

std::optional<ProgressLine> CompileProgress::finished() {
  const CompileProgress last = std::exchange(*this, {});
  if (last.done_ == 0) {
    return std::nullopt;
  }
  return ProgressLine{
      last.next_ > first_notice ? LogLevel::progress : LogLevel::info,
      fmt::format("compiled {} shader programs for refined draws in {:.1f} s", last.done_, last.seconds_)};
}

}  // namespace glark::core
