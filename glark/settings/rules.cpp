// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/rules.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include "glark/settings/settings.h"
#include "glark/settings/table.h"

namespace glark::settings {
namespace {

// In the order of the tokens from GL_NEVER on.
constexpr std::array<std::string_view, 8> depth_functions{
    "never", "less", "equal", "less-or-equal", "greater", "not-equal", "greater-or-equal", "always"};

template <std::optional<bool> core::DrawRule::*member>
bool read_state(core::DrawRule& rule, std::string_view text) {
  const std::optional<bool> state = parse_switch(text);
  if (state) rule.*member = state;
  return state.has_value();
}

bool read_program(core::DrawRule& rule, std::string_view text) {
  const auto hashes = parse_hashes(text);
  if (!hashes || hashes->size() != 1) return false;
  rule.program = hashes->front();
  return true;
}

bool read_depth_function(core::DrawRule& rule, std::string_view text) {
  const auto* const found = std::find(depth_functions.begin(), depth_functions.end(), text);
  if (found == depth_functions.end()) return false;
  rule.depth_function = GL_NEVER + static_cast<GLenum>(found - depth_functions.begin());
  return true;
}

// An array of two numbers reaches us as "640,480".
bool read_viewport(core::DrawRule& rule, std::string_view text) {
  std::array<unsigned, 2> size{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size[0]);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != ',') return false;
  const auto height = std::from_chars(width.ptr + 1, end, size[1]);
  if (height.ec != std::errc{} || height.ptr != end) return false;
  rule.viewport = size;
  return true;
}

bool read_refinement(core::DrawRule& rule, std::string_view text) {
  if (text == "none") {
    rule.refinement.reset();
    return true;
  }
  const std::optional<core::Refinement> refinement = parse_refinement(text);
  if (refinement) rule.refinement = refinement;
  return refinement.has_value();
}

constexpr char state_needed[] = "true or false";
using Rule = core::DrawRule;

// clang-format off
constexpr std::array keys{
    RuleKey{"program", "a hash of 16 hexadecimal digits", "The shader program has this hash", read_program},
    RuleKey{"fixed-function", state_needed, "The draw uses the fixed function", read_state<&Rule::fixed_function>},
    RuleKey{"depth-only", state_needed, "No colour can change: glColorMask is closed, or the framebuffer has no colour buffer", read_state<&Rule::depth_only>},
    RuleKey{"color-writes", state_needed, "glColorMask lets a component through", read_state<&Rule::color_writes>},
    RuleKey{"depth-test", state_needed, "GL_DEPTH_TEST is on", read_state<&Rule::depth_test>},
    RuleKey{"depth-writes", state_needed, "GL_DEPTH_TEST and glDepthMask are on", read_state<&Rule::depth_writes>},
    RuleKey{"depth-function", "never, less, equal, less-or-equal, greater, not-equal, greater-or-equal or always", "The value of glDepthFunc", read_depth_function},
    RuleKey{"blend", state_needed, "GL_BLEND is on", read_state<&Rule::blend>},
    RuleKey{"viewport", "a width and a height, like [1024, 1024]", "The size of glViewport", read_viewport},
    RuleKey{"refine", "none or a refinement of --refine", "What such draws get; none leaves them unrefined", read_refinement},
};
// clang-format on

}  // namespace

std::span<const RuleKey> rule_keys() { return keys; }

const RuleKey* find_rule_key(std::string_view key) {
  const auto* const found = std::find_if(keys.begin(), keys.end(), [&](const RuleKey& row) { return row.key == key; });
  return found != keys.end() ? found : nullptr;
}

std::string depth_function_name(GLenum function) {
  const GLenum index = function - GL_NEVER;
  return std::string(index < depth_functions.size() ? depth_functions[index] : "unknown");
}

}  // namespace glark::settings
