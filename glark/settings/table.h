// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The table of settings, one row each. `glark run --help`, docs/reference/options.md and the manual page are printed
// from it, and the defaults of Settings come from it.
#pragma once

#include <span>
#include <string_view>

#include "glark/settings/settings.h"

namespace glark::settings {

// The launcher treats the value of an option by its kind before it puts the value into the environment.
enum class Kind {
  value,
  toggle,         // an option without a value
  output_file,    // made absolute, refused if it cannot be written
  output_folder,  // created
  input_file,     // made absolute, refused if it cannot be read
  captures,       // FRAME:FILE.png, may be repeated
};

struct Setting {
  std::string_view group;  // the heading in the help and in the documents
  std::string_view key;    // the key in a configuration file; the option is "--" and the key
  const char* variable;
  Kind kind;
  std::string_view value;   // the placeholder of the value in the help; empty for a toggle
  std::string_view needed;  // the limits of the value: completes "... is needed"
  std::string_view
      initial;             // the default, as a text that `read` accepts; empty: Settings is right as it is constructed
  std::string_view shown;  // the default in words, if `initial` does not say it
  std::string_view help;   // one sentence
  std::string_view details;                                 // further sentences for the documents; may be empty
  bool (*read)(Settings& settings, std::string_view text);  // returns false and changes nothing if `text` is no value
  bool in_file = true;                                      // whether a configuration file may have the key
};

std::span<const Setting> table();
const Setting* find_setting(std::string_view key);
std::string_view shown_default(const Setting& setting);

// Returns the key that `wrong` was probably meant to be, or an empty text.
std::string_view nearest_key(std::string_view wrong);

// Sets the setting as the user wants. Returns false and changes nothing if `text` is no value of it.
bool give(const Setting& setting, Settings& settings, std::string_view text);

// Sets every setting to its default.
void apply_defaults(Settings& settings);

}  // namespace glark::settings
