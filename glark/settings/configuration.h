// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Configuration files: TOML; keys for all programs first, then a table [program.NAME] for each program with its own
// keys.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glark/settings/settings.h"

namespace glark::settings {

// Larger files are refused: a configuration is written by hand.
inline constexpr std::size_t longest_configuration = 256 * 1024;

// Applies the keys for all programs, then the tables of the programs `names`, in this order. Adds a sentence
// "FILE:LINE:COLUMN: ..." to `problems` for each error; the rest of the file counts.
void apply_configuration(std::string_view text, const std::string& file, std::span<const std::string> names,
                         Settings& settings, std::vector<std::string>& problems);

// Returns whether the text is TOML. The tables without errors of other texts are applied, too.
bool is_toml(std::string_view text);

// Returns the file that this environment names or has in its XDG folders; empty if there is none.
std::string find_configuration(const char* const* environment);

// Returns the text of a file of at most `longest_configuration` bytes; otherwise nothing, with the reason in `problem`.
std::optional<std::string> read_configuration(const std::string& file, std::string& problem);

// Returns the names of a program in [program.NAME], the most specific last: the executable file; the name that the
// program was called by; and for an interpreter (Python, Wine, Java ...) the script that it runs, with and without its
// ending.
std::vector<std::string> program_names(const std::string& executable, std::span<const std::string> arguments);

}  // namespace glark::settings
