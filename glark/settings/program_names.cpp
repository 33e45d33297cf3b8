// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>

#include "glark/settings/configuration.h"

namespace glark::settings {
namespace {

// Windows programs under Wine have paths with backslashes.
std::string base_name(std::string_view path) { return std::string(path.substr(path.find_last_of("/\\") + 1)); }

// python3, python3.11, wine64-preloader, perl5.36 ...: the leading letters name the interpreter.
bool is_interpreter(const std::string& name) {
  constexpr std::array<std::string_view, 10> known{"python", "pypy", "wine", "java", "perl",
                                                   "ruby",   "bash", "sh",   "node", "mono"};
  const auto end = std::find_if(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c) == 0; });
  return std::find(known.begin(), known.end(),
                   std::string_view(name.data(), static_cast<std::size_t>(end - name.begin()))) != known.end();
}

void add(std::vector<std::string>& names, std::string name) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
}

std::string without_ending(const std::string& name) {
  for (const std::string_view ending : {".py", ".exe", ".EXE", ".jar", ".pl", ".rb", ".sh", ".js"})
    if (name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

void add_with_and_without_ending(std::vector<std::string>& names, const std::string& path) {
  const std::string name = base_name(path);
  add(names, name);
  add(names, without_ending(name));
}

}  // namespace

std::vector<std::string> program_names(const std::string& executable, std::span<const std::string> arguments) {
  std::vector<std::string> names;
  add(names, base_name(executable));
  if (!arguments.empty()) add_with_and_without_ending(names, arguments[0]);
  const bool interprets = std::any_of(names.begin(), names.end(), is_interpreter);
  if (!interprets || arguments.size() < 2) return names;
  // The options of the interpreter come first. `-m module` names a program, `-c` does not.
  for (std::size_t i = 1; i < arguments.size() && arguments[i] != "-c"; ++i) {
    if (arguments[i] == "-m" || arguments[i] == "-jar" || arguments[i] == "-X" || arguments[i] == "-W") {
      if (arguments[i] == "-X" || arguments[i] == "-W") ++i;
      continue;
    }
    if (arguments[i].starts_with("-")) continue;
    add_with_and_without_ending(names, arguments[i]);
    break;
  }
  return names;
}

}  // namespace glark::settings
