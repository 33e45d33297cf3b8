// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Completion of glark's commands, options and values in a shell, written from the table of settings.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glark/settings/table.h"

namespace glark::tool {

struct CommandLine {
  std::string name;
  std::string help;  // one sentence
};

// The words that are values of a setting, from its limits; empty if the value is no word.
std::vector<std::string> words_of(const settings::Setting& setting);

std::string bash_completion(std::span<const CommandLine> commands, std::span<const std::string> topics);
std::string zsh_completion(std::span<const CommandLine> commands, std::span<const std::string> topics);

}  // namespace glark::tool
