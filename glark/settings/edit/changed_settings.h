// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A user's changes while a program runs, as lines of a configuration file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glark/core/context_options.h"

namespace glark::settings {

struct ChangedSetting {
  std::string_view key;  // from the table
  std::string value;     // in TOML
};

// The settings of `after` that differ from `before`. Settings that change only the view of the draws do not count.
std::vector<ChangedSetting> changed_settings(const core::ContextOptions& before, const core::ContextOptions& after);

// The rules of `after` that `before` lacks.
std::vector<core::DrawRule> added_rules(const core::ContextOptions& before, const core::ContextOptions& after);

// The lines "key = value" of a [[rule]].
std::string text_of_rule(const core::DrawRule& rule);

}  // namespace glark::settings
