// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Calls of OpenGL as a function in C. Long arrays get names; their contents follow the function, so that the calls are
// what one reads first.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace glark::conformance {

class CProgram {
 public:
  // A call or a comment, without indentation.
  void add(std::string line) { lines_.push_back(std::move(line)); }
  // The name of an array of `count` elements. `elements` is what stands between the braces. Equal arrays have one name.
  std::string array(std::string_view type, std::size_t count, const std::string& elements);
  void clear();
  // `head`: comments and includes.
  std::string text(std::string_view head) const;

 private:
  std::vector<std::string> lines_;
  std::vector<std::string> declarations_;  // of arrays, without contents
  std::vector<std::string> contents_;
  std::map<std::string, std::string> names_;  // of arrays, by type and contents
};

// A string in C, in one literal for each line.
std::string c_string(std::string_view text);
// The text in lines of at most 110 characters, broken at spaces.
std::string in_lines(std::string_view text, std::string_view indentation);

}  // namespace glark::conformance
