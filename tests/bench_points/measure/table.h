// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tables of figures, as Markdown and as JSON.
#pragma once

#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace glark::bench {

// A cell: nothing, a word, or a number with `digits` digits after the point.
struct Number {
  double value;
  int digits;
};
using Cell = std::variant<std::monostate, std::string, Number>;

struct Table {
  std::string title;
  std::vector<std::string> columns;  // the first has the names of the rows
  std::vector<std::vector<Cell>> rows;
  std::string note = {};  // printed below the table
};

std::string markdown_of(const std::vector<Table>& tables);
std::string json_of(const std::vector<Table>& tables);

// Replaces the text of the file between the lines "<!-- glark-bench-points -->" and "<!-- end of glark-bench-points
// -->". Throws std::runtime_error if these lines or the file are missing.
void replace_in(const std::string& file, const std::string& markdown);

}  // namespace glark::bench
