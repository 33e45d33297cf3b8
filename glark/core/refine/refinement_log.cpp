// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/refinement_log.h"

#include <cctype>
#include <charconv>

#include "glark/core/refine/glsl/rewrite.h"

namespace glark::refine {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The place of a line number of the refinement shader in a line of the log.
struct Place {
  std::size_t begin = std::string::npos;  // of the number of the source string in front of it
  std::size_t end = 0;
  int line = 0;
};

// Drivers write "0:3(5):", "ERROR: 0:3:" or "0(3) :".
Place find_place(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    if (!is_digit(text[i]) || (i > 0 && is_name(text[i - 1]))) {
      ++i;
      continue;
    }
    int number = 0;
    const char* const end = std::from_chars(text.data() + i, text.data() + text.size(), number).ptr;
    const auto after = static_cast<std::size_t>(end - text.data());
    if (number >= first_refinement_line && number < first_line_after_refinement) {
      std::size_t begin = i;
      if (begin > 1 && (text[begin - 1] == ':' || text[begin - 1] == '(') && is_digit(text[begin - 2])) {
        for (--begin; begin > 0 && is_digit(text[begin - 1]);) --begin;
      }
      const bool closed = text[i > 0 ? i - 1 : 0] == '(' && after < text.size() && text[after] == ')';
      return {begin, closed ? after + 1 : after, number - first_refinement_line + 1};
    }
    i = after > i ? after : i + 1;
  }
  return {};
}

bool is_warning(std::string_view text) {
  return text.find("warning") != std::string_view::npos || text.find("WARNING") != std::string_view::npos;
}

std::string name_of_author(const std::string& name, const std::string& prefix) {
  if (!name.starts_with(prefix)) return name;
  std::string rest = name.substr(prefix.size());
  if (rest == "refine") return rest;
  if (rest.starts_with("application_")) return rest.substr(std::string_view("application_").size());
  return built_in_input("gl_" + rest) != nullptr ? "gl_" + rest : name;
}

std::string with_names_of_author(std::string_view text, const std::string& prefix) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_name(text[end])) ++end;
    if (end == i) {
      result += text[i++];
      continue;
    }
    result += name_of_author(std::string(text.substr(i, end - i)), prefix);
    i = end;
  }
  return result;
}

}  // namespace

std::string log_for_author(std::string_view log, const std::string& prefix) {
  std::string result;
  while (!log.empty()) {
    const std::size_t end = log.find('\n');
    const std::string_view text = log.substr(0, end);
    log.remove_prefix(end == std::string_view::npos ? log.size() : end + 1);
    const Place place = find_place(text);
    const bool own = place.begin != std::string::npos;
    if (!own && is_warning(text)) continue;
    std::string line(text);
    if (own) line.replace(place.begin, place.end - place.begin, "refinement shader:" + std::to_string(place.line));
    result += with_names_of_author(line, prefix) + (end == std::string_view::npos ? "" : "\n");
  }
  return result;
}

}  // namespace glark::refine
