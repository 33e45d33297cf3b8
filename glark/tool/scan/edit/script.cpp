// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/edit/script.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace glark::tool {

bool is_comment(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

std::vector<ScriptLine> read_script(const std::string& file) {
  std::ifstream opened;
  if (file != "-") opened.open(file);
  std::istream& stream = file == "-" ? std::cin : opened;
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  std::vector<ScriptLine> script;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (is_comment(line)) continue;
    try {
      script.push_back({number, edit::parse(line)});
    } catch (const edit::Error& error) {
      throw std::runtime_error(fmt::format("{}: line {}: {}", file, number, error.what()));
    }
  }
  if (stream.bad()) throw std::runtime_error(fmt::format("{}: cannot be read to its end", file));
  return script;
}

}  // namespace glark::tool
