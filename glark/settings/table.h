// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every setting once: its key in a configuration file, its option of `glark run`, its variable, its value and what it does.
#pragma once

#include <span>
#include <string_view>

#include "glark/settings/settings.h"

namespace glark::settings {

// How the launcher treats the value of an option before it sets the variable.
enum class Kind {
  value,
  toggle,         // an option without a value
  output_file,    // made absolute, and refused if it cannot be written
  output_folder,  // made
  input_file,     // made absolute, and refused if it cannot be read
  captures,       // FRAME:FILE.png, may be repeated
};

struct Setting {
  std::string_view key;  // in a configuration file; the option is "--" and this
  const char* variable;  // null: configuration files only
  Kind kind;
  std::string_view value;   // its placeholder in --help and the manual; empty: a switch
  std::string_view needed;  // completes "... is needed"
  std::string_view help;
  bool (*read)(Settings& settings, std::string_view text);  // false if `text` is not a value; then nothing changes
  bool in_file = true;                                      // a configuration file may have it
};

std::span<const Setting> table();
const Setting* find_setting(std::string_view key);

}  // namespace glark::settings
