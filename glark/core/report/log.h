// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Log lines of the core. The core never prints; the host installs a sink.
#pragma once

#include <string_view>

namespace glark::core {

// progress: for users who wait at a terminal; where nobody reads along, it counts as info.
enum class LogLevel { error, warning, progress, info, debug };

// Installed by the shim or a test; nullptr discards. Called from any thread.
using LogSink = void (*)(LogLevel level, std::string_view message);
void set_log_sink(LogSink sink);
void log(LogLevel level, std::string_view message);

}  // namespace glark::core
