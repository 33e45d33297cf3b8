// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "glark/clients/edit/text/operations.h"

namespace glark::edit {
namespace {

std::string names() {
  std::string list;
  for (const Row& row : rows()) list += (list.empty() ? "" : ", ") + std::string(row.form.name);
  return list;
}

[[noreturn]] void reject(const std::string& problem) { throw Error(Element::operation, 0, problem); }

}  // namespace

Operation parse(std::string_view line) {
  Words words(line);
  if (words.at_end()) reject(fmt::format("there is no operation; write one of {}", names()));
  const std::string_view name = words.word("the operation");
  for (const Row& row : rows()) {
    if (name != row.form.name) continue;
    try {
      Operation operation = row.read(words);
      if (!words.at_end()) throw BadWord(fmt::format("\"{}\" is one word too many", words.word("")));
      return operation;
    } catch (const BadWord& problem) {
      reject(fmt::format("{}: {}; write: {}", name, problem.what(), row.form.form));
    }
  }
  reject(fmt::format("\"{}\" is no operation; write one of {}", name, names()));
}

}  // namespace glark::edit
