// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Colours on terminals.
#pragma once

#include <string_view>

namespace glark::settings {

namespace style {
inline constexpr std::string_view bold = "\033[1m";
inline constexpr std::string_view red = "\033[31m";
inline constexpr std::string_view yellow = "\033[33m";
inline constexpr std::string_view plain = "\033[0m";
}  // namespace style

// Returns whether text to this file descriptor may have colours: a terminal shows it, and the user has not set NO_COLOR
// (https://no-color.org) or TERM=dumb.
bool has_colors(int file);

// The rule without the terminal.
bool allows_colors(const char* const* environment);

}  // namespace glark::settings
