// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Changes a configuration file as a careful user would: other lines, their order and comments stay.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "glark/settings/edit/changed_settings.h"

namespace glark::settings {

// Returns the text with the settings in [program.NAME], and with a [[program.NAME.rule]] for each rule. A key that is
// there gets the new value.
std::string with_settings(std::string_view text, std::string_view program, std::span<const ChangedSetting> changed,
                          std::span<const core::DrawRule> rules);

// Where settings are written: the file that is read, or glark/glark.toml in the user's XDG folder. Empty: the
// environment names no such folder.
std::string writable_configuration(const char* const* environment);

// Writes the file with the changes for `program`, atomically; makes its folder. Returns a sentence if it cannot, or if
// the new text would not be read as it is meant; then nothing is changed.
std::string write_configuration(const std::string& file, const std::string& program,
                                std::span<const ChangedSetting> changed, std::span<const core::DrawRule> rules);

}  // namespace glark::settings
