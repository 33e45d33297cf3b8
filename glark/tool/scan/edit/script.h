// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Files with an operation in each line.
#pragma once

#include <glark/edit.h>

#include <string>
#include <vector>

namespace glark::tool {

struct ScriptLine {
  std::size_t number = 0;  // in the file, from 1
  edit::Operation operation;
};

// Empty lines, and those that begin with #, are comments.
bool is_comment(const std::string& line);

// Reads all lines; "-" is standard input. Throws std::runtime_error, which names the file and the line, if a line is no
// operation.
std::vector<ScriptLine> read_script(const std::string& file);

}  // namespace glark::tool
