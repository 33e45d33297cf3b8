// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/log.h"

#include <atomic>

namespace glark::core {
namespace {

std::atomic<LogSink> log_sink{nullptr};

}  // namespace

void set_log_sink(LogSink wanted) { log_sink.store(wanted, std::memory_order_relaxed); }

void log(LogLevel level, std::string_view message) {
  if (const LogSink current = log_sink.load(std::memory_order_relaxed); current != nullptr) {
    current(level, message);
  }
}

}  // namespace glark::core
