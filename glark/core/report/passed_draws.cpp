// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/passed_draws.h"

#include "glark/core/report/log.h"
#include "glark/core/report/statistics.h"

namespace glark::core {

std::string PassedDraws::count(Cause cause, bool audible) {
  const auto index = static_cast<std::size_t>(cause);
  ++statistics().passed_through[index];
  if (logged_[index] && (sent_[index] || !audible)) {
    return {};
  }
  const CauseText& text = text_of(cause);
  const bool expected = cause == Cause::not_triangles || cause == Cause::level_zero ||
                        cause == Cause::rasterizer_discard || cause == Cause::mesh_waits ||
                        cause == Cause::invalid_draw || cause == Cause::compiling;
  const std::string message = "draws stay as the application asked: " + std::string(text.explanation) +
                              "; to change that: " + std::string(text.remedy);
  if (!logged_[index]) {
    log(expected ? LogLevel::debug : LogLevel::info, message);
  }
  logged_.set(index);
  if (audible) {
    sent_.set(index);
  }
  return expected || !audible ? std::string() : message;
}

}  // namespace glark::core
