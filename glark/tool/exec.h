// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands that are separate programs, because their libraries would make `glark run` slow to start.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace glark::tool {

struct OtherCommand {
  const char* name;
  const char* program;
  const char* help;
};

std::span<const OtherCommand> other_commands();

// Looks for the program beside the launcher and where it is installed. Returns nothing if it was not built.
std::optional<std::string> find_program(const std::string& program);

// Returns the program for the words after "glark", or null for a command of the launcher itself.
const char* program_of(std::span<char* const> words);

// Becomes the program. Returns only on failure: an exit status, after a message on standard error.
int become(const std::string& program, char** argv);

}  // namespace glark::tool
