// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "glark/settings/configuration.h"
#include "glark/settings/table.h"

namespace glark::settings {
namespace {

void read_configuration_file(const char* const* environment, std::span<const std::string> names, Parsed& parsed) {
  const std::string file = find_configuration(environment);
  if (file.empty()) return;
  std::string problem;
  if (const std::optional<std::string> text = read_configuration(file, problem))
    apply_configuration(*text, file, names, parsed.settings, parsed.problems);
  else
    parsed.problems.push_back(problem);
}

// The conformance suite judges the extension from its initial state, which `glark run` must not change.
bool makes_its_own_calls(std::span<const std::string> names) {
  return std::find(names.begin(), names.end(), "glark-conformance") != names.end();
}

std::string wrong_value(std::string_view name, std::string_view text, std::string_view needed) {
  return fmt::format("{} is \"{}\"; {} is needed", name, text, needed);
}

// An empty variable counts as unset.
void read_variables(const char* const* environment, Parsed& parsed) {
  for (const Setting& setting : table()) {
    const std::optional<std::string_view> text = find_variable(environment, setting.variable);
    if (text && !text->empty() && !setting.read(parsed.settings, *text))
      parsed.problems.push_back(wrong_value(setting.variable, *text, setting.needed));
  }
}

// A level above the default limit raises the limit. A limit that the user set lowers the level.
void limit_level(Parsed& parsed) {
  core::ContextOptions& context = parsed.settings.context;
  if (context.level <= context.max_level) return;
  if (parsed.settings.max_level_set) {
    parsed.problems.push_back(
        fmt::format("the level {0} exceeds the limit {1}; {1} is used; raise GLARK_MAX_LEVEL or max-level",
                    context.level, context.max_level));
    context.level = context.max_level;
  } else {
    context.max_level = context.level;
  }
}

void warn_of_unused(Parsed& parsed) {
  const core::ContextOptions& context = parsed.settings.context;
  if (context.measure.budget > 0 && !context.measure.on())
    parsed.problems.emplace_back("GLARK_BUDGET has no effect without GLARK_EDGE_PIXELS or GLARK_CURVATURE");
  for (const core::RefinementTraits& row : core::refinements) {
    const float number = context.shape_numbers.at(static_cast<std::size_t>(row.refinement));
    if (number != row.number.initial && context.refinement != row.refinement)
      parsed.problems.push_back(fmt::format("{} has no effect without GLARK_REFINE={}", row.number.variable, row.word));
  }
  if (context.geomorph && !context.measure.on())
    parsed.problems.emplace_back("GLARK_GEOMORPH has no effect without GLARK_EDGE_PIXELS or GLARK_CURVATURE");
}

}  // namespace

std::optional<std::string_view> find_variable(const char* const* environment, std::string_view name) {
  for (; environment != nullptr && *environment != nullptr; ++environment) {
    const std::string_view entry = *environment;
    if (entry.size() > name.size() && entry[name.size()] == '=' && entry.starts_with(name))
      return entry.substr(name.size() + 1);
  }
  return std::nullopt;
}

Parsed parse(const char* const* environment, std::span<const std::string> names) {
  Parsed parsed;
  Settings& settings = parsed.settings;
  apply_defaults(settings);
  settings.leave_alone = makes_its_own_calls(names);
  read_configuration_file(environment, names, parsed);
  if (const auto enable = find_variable(environment, variable::enable); enable && !enable->empty()) {
    if (const std::optional<bool> wanted = parse_switch(*enable))
      settings.context.transparent = *wanted;
    else
      parsed.problems.push_back(wrong_value(variable::enable, *enable, "0 or 1"));
  }
  read_variables(environment, parsed);
  limit_level(parsed);
  warn_of_unused(parsed);
  settings.context.transparent = settings.context.transparent && !settings.leave_alone;
  settings.context.read_counts = !settings.statistics_file.empty();
  if (settings.everything) {
    settings.context.left_draws = 0;
    settings.context.left_shaders.clear();
  }
  return parsed;
}

}  // namespace glark::settings
