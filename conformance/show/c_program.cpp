// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/show/c_program.h"

#include <fmt/core.h>

#include <algorithm>

namespace glark::conformance {

std::string CProgram::array(std::string_view type, std::size_t count, const std::string& elements) {
  const auto [found, is_new] = names_.try_emplace(fmt::format("{} {}", type, elements));
  if (!is_new) return found->second;
  found->second = fmt::format("data_{}", names_.size());
  declarations_.push_back(fmt::format("static const {} {}[{}];", type, found->second, count));
  contents_.push_back(
      fmt::format("static const {} {}[{}] = {{\n{}}};", type, found->second, count, in_lines(elements, "    ")));
  return found->second;
}

void CProgram::clear() {
  lines_.clear();
  declarations_.clear();
  contents_.clear();
  names_.clear();
}

std::string CProgram::text(std::string_view head) const {
  std::string text(head);
  for (const std::string& each : declarations_) text += each + '\n';
  text +=
      "static unsigned char results[1 << 22];  // for what OpenGL writes\nstatic GLsync sync;\n\nvoid draw(void) {\n";
  for (const std::string& each : lines_) text += "  " + each + '\n';
  text += "}\n";
  for (const std::string& each : contents_) text += '\n' + each + '\n';
  return text;
}

std::string c_string(std::string_view text) {
  std::string literal = "\"";
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      literal += i + 1 < text.size() ? "\\n\"\n      \"" : "\\n";
    } else if (c == '"' || c == '\\') {
      literal += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) {
      literal += fmt::format("\\{:03o}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      literal += c;
    }
  }
  return literal + '"';
}

std::string in_lines(std::string_view text, std::string_view indentation) {
  constexpr std::size_t width = 110;
  std::string lines;
  while (!text.empty()) {
    std::size_t end = std::min(text.find('\n'), text.size());
    if (end > width) end = text.rfind(' ', width);
    if (end == std::string_view::npos || end == 0) end = std::min(text.find_first_of(" \n", width), text.size());
    lines += fmt::format("{}{}\n", indentation, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace glark::conformance
