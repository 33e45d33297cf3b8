// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glark pattern A B C [--interior KIND] [-o FILE.svg]: draws a pattern.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace glark::tool {

struct PatternOptions {
  std::vector<int> depths;
  std::string interior = "minimum";
  std::string file;  // empty: standard output
};

void describe_pattern(CLI::App& command, PatternOptions& options);

// Returns the exit status.
int draw_pattern(const PatternOptions& options);

}  // namespace glark::tool
