// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How the commands for files end where they cannot go on.
#pragma once

#include <cctype>
#include <cstdio>
#include <regex>
#include <string>
#include <string_view>

namespace glark::tool {

inline constexpr int exit_failure = 1;
inline constexpr int exit_usage = 2;

// The libraries name their options as C++ and Python have them: "the option skip_invalid" becomes "--skip-invalid".
inline std::string with_options_of_the_command_line(std::string text) {
  constexpr std::string_view words = "the option ";
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at)) {
    text.replace(at, words.size(), "--");
    for (at += 2; at < text.size() && (std::islower(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
         ++at)
      if (text[at] == '_') text[at] = '-';
  }
  return text;
}

// The libraries begin their messages with their names: "glark-maps: array: no point ..." becomes "no point ...".
inline std::string without_library(const std::string& text) {
  static const std::regex library("^glark-[a-z]+: (array: )?");
  return std::regex_replace(text, library, "");
}

// Prints the problem. Returns the status, for the end of the program.
inline int complain(const std::string& problem, int status) {
  std::fprintf(stderr, "glark: %s\n", with_options_of_the_command_line(without_library(problem)).c_str());
  return status;
}

}  // namespace glark::tool
