// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands that are programs of their own: what they link to would make `glark run` slow to start.
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

// Beside the launcher, or where it is installed to; nothing where it was not built.
std::optional<std::string> find_program(const std::string& program);

// The program for these words behind "glark"; nothing for the launcher's own commands.
const char* program_of(std::span<char* const> words);

// Becomes it. Returns only if that fails: an exit status, after a message on standard error.
int become(const std::string& program, char** argv);

}  // namespace glark::tool
