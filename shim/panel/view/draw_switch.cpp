// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/draw_switch.h"

#include <algorithm>
#include <utility>

namespace glark::shim {

core::DrawRule rule_against(const core::DrawState& state) {
  core::DrawRule rule;
  if (state.program != 0) rule.program = state.program;
  rule.fixed_function = state.fixed_function;
  rule.depth_test = state.depth_test;
  rule.depth_writes = state.depth_writes;
  rule.depth_function = state.depth_function;
  rule.blend = state.blend;
  rule.color_writes = state.color_writes;
  rule.depth_only = state.depth_only;
  return rule;
}

bool is_switched_off(const core::ContextOptions& options, const core::DrawState& state) {
  return std::find(options.rules.begin(), options.rules.end(), rule_against(state)) != options.rules.end();
}

// The first rule that matches counts.
void switch_draws(core::ContextOptions& options, const core::DrawState& state, bool refine) {
  const core::DrawRule rule = rule_against(state);
  std::erase(options.rules, rule);
  if (!refine) options.rules.insert(options.rules.begin(), rule);
}

std::optional<core::DrawState> seen_at_pixel(const std::vector<core::WatchedClass>& classes) {
  const auto rank = [](const core::WatchedClass& draws) {
    return std::pair{draws.group() != core::DrawGroup::interface, draws.pixel_step};
  };
  const core::WatchedClass* best = nullptr;
  for (const core::WatchedClass& draws : classes)
    if (draws.pixel_step > 0 && (best == nullptr || rank(draws) > rank(*best))) best = &draws;
  return best != nullptr ? std::optional(best->key.state) : std::nullopt;
}

}  // namespace glark::shim
