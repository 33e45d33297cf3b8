// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Log lines of the core. The core never prints; the host installs a sink.
#pragma once

#include <string_view>

namespace glark::core {

enum class LogLevel { error, warning, info, debug };

// Installed by the shim or a test; nullptr discards. Called from any thread.
using LogSink = void (*)(LogLevel level, std::string_view message);
void set_log_sink(LogSink sink);
void log(LogLevel level, std::string_view message);

}  // namespace glark::core
