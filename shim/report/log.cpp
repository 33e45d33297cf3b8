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

namespace glark::shim {
namespace {

std::atomic<core::LogLevel> most_verbose{core::LogLevel::warning};

// A user who sees warnings at a terminal also sees why a program takes long to start.
bool is_shown(core::LogLevel level) {
  const core::LogLevel most = most_verbose.load(std::memory_order_relaxed);
  return level <= most ||
         (level == core::LogLevel::progress && most == core::LogLevel::warning && isatty(STDERR_FILENO) != 0);
}

iovec piece(std::string_view text) { return {const_cast<char*>(text.data()), text.size()}; }

void write_line(core::LogLevel level, std::string_view message) {
  constexpr std::array<std::string_view, 5> prefixes{
      "glark: error: ", "glark: ", "glark: ", "glark: ", "glark: debug: "};
  const int saved = errno;
  if (!is_shown(level)) {
    errno = saved;
    return;
  }
  const std::array pieces{piece(prefixes[static_cast<std::size_t>(level)]), piece(message), piece("\n")};
  static_cast<void>(!writev(STDERR_FILENO, pieces.data(), pieces.size()));
  errno = saved;
}

}  // namespace

void install_log(core::LogLevel level) {
  most_verbose.store(level, std::memory_order_relaxed);
  core::set_log_sink(write_line);
}

}  // namespace glark::shim
