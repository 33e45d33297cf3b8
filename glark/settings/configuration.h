// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Configuration files: TOML, keys of all programs first, then a table [program.NAME] for each program with keys of its own.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glark/settings/settings.h"

namespace glark::settings {

// Larger ones are refused: a configuration is written by hand.
inline constexpr std::size_t longest_configuration = 256 * 1024;

// Applies the keys of all programs, then those of the programs that `names` has, in the order of `names`. What is wrong is
// told in `problems`, each "FILE:LINE:COLUMN: ..."; the rest of the file counts.
void apply_configuration(std::string_view text, const std::string& file, std::span<const std::string> names,
                         Settings& settings, std::vector<std::string>& problems);

// The file that this environment names or has in its XDG folders; empty: none.
std::string find_configuration(const char* const* environment);

// The text of a file of at most `longest_configuration` bytes; otherwise nothing, with the reason in `problem`.
std::optional<std::string> read_configuration(const std::string& file, std::string& problem);

// The names that a program may have in [program.NAME], the most specific last: the file that is executed, the name that it was
// called by, and, where the program is an interpreter (Python, Wine, Java ...), what it runs, with and without its ending.
std::vector<std::string> program_names(const std::string& executable, std::span<const std::string> arguments);

}  // namespace glark::settings
