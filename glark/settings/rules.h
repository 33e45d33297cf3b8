// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The keys of a [[rule]] in a configuration file: conditions on the state of a draw, and the refinement that it gets.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "glark/core/draw_rule.h"

namespace glark::settings {

struct RuleKey {
  std::string_view key;
  std::string_view needed;                                    // completes "... is needed"
  std::string_view help;                                      // one sentence
  bool (*read)(core::DrawRule& rule, std::string_view text);  // returns false and changes nothing if `text` is no value
};

std::span<const RuleKey> rule_keys();
const RuleKey* find_rule_key(std::string_view key);

// "less", "equal" ...; "unknown" for a number that is no depth function.
std::string depth_function_name(GLenum function);

}  // namespace glark::settings
