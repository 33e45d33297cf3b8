// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Messages go out by one writev(2), not by a logging library: a line stays whole among several threads and processes,
// and nothing is constructed or destroyed, so that it works before main and after exit.
#include "shim/report/log.h"

#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>

#include "glark/settings/terminal.h"

namespace glark::shim {
namespace {

std::atomic<core::LogLevel> most_verbose{core::LogLevel::warning};
std::atomic<bool> colored{false};

// A user who sees warnings at a terminal also sees why a program takes long to start.
bool is_shown(core::LogLevel level) {
  const core::LogLevel most = most_verbose.load(std::memory_order_relaxed);
  return level <= most ||
         (level == core::LogLevel::progress && most == core::LogLevel::warning && isatty(STDERR_FILENO) != 0);
}

std::string_view color_of(core::LogLevel level) {
  if (!colored.load(std::memory_order_relaxed)) return {};
  if (level == core::LogLevel::error) return settings::style::red;
  return level == core::LogLevel::warning ? settings::style::yellow : settings::style::bold;
}

iovec piece(std::string_view text) { return {const_cast<char*>(text.data()), text.size()}; }

void write_line(core::LogLevel level, std::string_view message) {
  constexpr std::array<std::string_view, 5> prefixes{"glark: error:", "glark:", "glark:", "glark:", "glark: debug:"};
  const int saved = errno;
  if (!is_shown(level)) {
    errno = saved;
    return;
  }
  const std::array pieces{piece(color_of(level)),
                          piece(prefixes[static_cast<std::size_t>(level)]),
                          piece(colored.load(std::memory_order_relaxed) ? settings::style::plain : ""),
                          piece(" "),
                          piece(message),
                          piece("\n")};
  static_cast<void>(!writev(STDERR_FILENO, pieces.data(), pieces.size()));
  errno = saved;
}

}  // namespace

void install_log(core::LogLevel level) {
  most_verbose.store(level, std::memory_order_relaxed);
  colored.store(settings::has_colors(STDERR_FILENO), std::memory_order_relaxed);
  core::set_log_sink(write_line);
}

}  // namespace glark::shim
