// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/edit/prompt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>

#include "glark/tool/scan/console.h"
#include "glark/tool/scan/edit/script.h"

namespace glark::tool {
namespace {

void print_help() {
  for (const edit::Form& form : edit::forms()) std::printf("%s\n    %s\n", form.form, form.help);
  std::printf("save FILE\n    Transfer the edit to the scan\nquit\n    The session stays on the disk\n");
}

// Returns false at the end.
bool run_line(const std::string& line, edit::Session& session, const std::function<void(const std::string&)>& save) {
  const std::size_t begin = line.find_first_not_of(" \t\r"), end = line.find_last_not_of(" \t\r") + 1;
  const std::string text = line.substr(begin, end - begin);
  if (text == "quit") return false;
  if (text == "help")
    print_help();
  else if (text == "save")
    throw std::runtime_error("save: FILE is missing; write: save FILE");
  else if (text.starts_with("save "))
    save(text.substr(text.find_first_not_of(' ', 4)));
  else
    session.apply(edit::parse(text));
  return true;
}

}  // namespace

void edit_by_prompt(edit::Session& session, const std::function<void(const std::string& output)>& save) {
  const bool on_terminal = isatty(STDIN_FILENO) == 1;
  if (on_terminal)
    std::printf("%zu samples, %zu operations; help lists the operations, quit ends\n", session.editor().size(),
                session.operations());
  std::string line;
  for (std::size_t number = 1;; ++number) {
    if (on_terminal) std::printf("edit> ");
    std::fflush(stdout);
    if (!std::getline(std::cin, line)) return;
    if (is_comment(line)) continue;
    try {
      if (!run_line(line, session, save)) return;
    } catch (const std::exception& error) {
      if (!on_terminal) throw std::runtime_error(fmt::format("standard input: line {}: {}", number, error.what()));
      warn(error.what());
    }
  }
}

}  // namespace glark::tool
