// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/edit/changed_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "glark/settings/rules.h"

namespace glark::settings {
namespace {

using Options = core::ContextOptions;

std::string quoted(std::string_view word) { return fmt::format("\"{}\"", word); }
std::string text_of(bool state) { return state ? "true" : "false"; }

// The shortest decimal that is read back as the same number, never with an exponent.
std::string text_of(float number) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed).ptr;
  const std::string text(digits.data(), end);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

struct Row {
  std::string_view key;
  std::string (*text)(const Options& options);
};

// clang-format off
constexpr std::array compared_rows{
    Row{"refine", [](const Options& o) { return quoted(o.smooth ? "smooth" : core::traits_of(o.refinement).word); }},
    Row{"level", [](const Options& o) { return std::to_string(o.level); }},
    Row{"max-level", [](const Options& o) { return std::to_string(o.max_level); }},
    Row{"edge-pixels", [](const Options& o) { return text_of(o.measure.pixels); }},
    Row{"screen-error", [](const Options& o) { return text_of(o.measure.error); }},
    Row{"curvature", [](const Options& o) { return text_of(o.measure.degrees); }},
    Row{"budget", [](const Options& o) { return std::to_string(o.measure.budget); }},
    Row{"geomorph", [](const Options& o) { return text_of(o.geomorph); }},
    Row{"crease", [](const Options& o) { return text_of(o.crease); }},
    Row{"wireframe", [](const Options& o) { return text_of(o.wireframe); }},
};
// clang-format on

template <class T>
void add(std::string& lines, std::string_view key, const std::optional<T>& value, auto text) {
  if (value) lines += fmt::format("{} = {}\n", key, text(*value));
}

}  // namespace

std::vector<ChangedSetting> changed_settings(const Options& before, const Options& after) {
  std::vector<ChangedSetting> changed;
  for (const Row& row : compared_rows)
    if (row.text(before) != row.text(after)) changed.push_back({row.key, row.text(after)});
  return changed;
}

std::vector<core::DrawRule> added_rules(const Options& before, const Options& after) {
  std::vector<core::DrawRule> added;
  for (const core::DrawRule& rule : after.rules)
    if (std::find(before.rules.begin(), before.rules.end(), rule) == before.rules.end()) added.push_back(rule);
  return added;
}

std::string text_of_rule(const core::DrawRule& rule) {
  const auto state = [](bool value) { return text_of(value); };
  std::string lines;
  add(lines, "program", rule.program, [](std::uint64_t hash) { return fmt::format("\"{:016x}\"", hash); });
  add(lines, "fixed-function", rule.fixed_function, state);
  add(lines, "depth-only", rule.depth_only, state);
  add(lines, "color-writes", rule.color_writes, state);
  add(lines, "depth-test", rule.depth_test, state);
  add(lines, "depth-writes", rule.depth_writes, state);
  add(lines, "depth-function", rule.depth_function, [](GLenum name) { return quoted(depth_function_name(name)); });
  add(lines, "blend", rule.blend, state);
  add(lines, "viewport", rule.viewport, [](const auto& size) { return fmt::format("[{}, {}]", size[0], size[1]); });
  lines += fmt::format("refine = {}\n", quoted(rule.refinement ? core::traits_of(*rule.refinement).word : "none"));
  return lines;
}

}  // namespace glark::settings
