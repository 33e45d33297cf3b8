// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "glark/settings/table.h"

namespace glark::tool {

// The exit statuses of shells.
inline constexpr int exit_usage = 2;
inline constexpr int exit_not_executable = 126;
inline constexpr int exit_not_found = 127;

// The values on the command line by the key of their setting; they are already checked.
using RunOptions = std::map<std::string_view, std::vector<std::string>>;

// Prints a message "glark: ..." on standard error.
void say(const std::string& message);

// Puts the options and the preload into the environment, and prints what the user has to know about the program. False,
// after a message, if a value is unusable or the library is missing.
bool prepare_run(const RunOptions& options, const std::vector<std::string>& command);

// Becomes the program. Returns only on failure: an exit status, after a message on standard error.
int become_program(const std::vector<std::string>& command);

// Both.
int run(const RunOptions& options, const std::vector<std::string>& command);

}  // namespace glark::tool
