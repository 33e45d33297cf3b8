// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/unrefined/draw_rules.h"

#include <algorithm>
#include <optional>

namespace glark::core {
namespace {

template <class T>
bool agrees(const std::optional<T>& wanted, const T& value) {
  return !wanted || *wanted == value;
}

bool matches(const DrawRule& rule, const DrawState& state) {
  return agrees(rule.program, state.program) && agrees(rule.fixed_function, state.fixed_function) &&
         agrees(rule.depth_test, state.depth_test) && agrees(rule.depth_writes, state.depth_writes) &&
         agrees(rule.depth_function, state.depth_function) && agrees(rule.blend, state.blend) &&
         agrees(rule.color_writes, state.color_writes) && agrees(rule.depth_only, state.depth_only) &&
         agrees(rule.viewport, state.viewport);
}

}  // namespace

const DrawRule* find_rule(std::span<const DrawRule> rules, const DrawState& state) {
  const auto found =
      std::find_if(rules.begin(), rules.end(), [&](const DrawRule& rule) { return matches(rule, state); });
  return found != rules.end() ? &*found : nullptr;
}

}  // namespace glark::core
