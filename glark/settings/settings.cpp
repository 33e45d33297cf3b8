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

// The conformance suite tests the extension in its initial state, so `glark run` must not change that state.
bool makes_its_own_calls(std::span<const std::string> names) {
  return std::find(names.begin(), names.end(), "glark-conformance") != names.end();
}

// An empty variable leaves its setting alone.
void read_variables(const char* const* environment, Parsed& parsed) {
  for (const Setting& setting : table()) {
    const std::optional<std::string_view> text = find_variable(environment, setting.variable);
    if (text && !text->empty() && !setting.read(parsed.settings, *text))
      parsed.problems.push_back(fmt::format("{} is \"{}\"; {} is needed", setting.variable, *text, setting.needed));
  }
}

// A level above the default limit raises the limit, unless the user has set the limit too.
void limit_level(Parsed& parsed) {
  core::ContextOptions& context = parsed.settings.context;
  if (context.level <= context.max_level) return;
  if (parsed.settings.max_level_set) {
    parsed.problems.push_back(
        fmt::format("the level is {}, more than the greatest level; it is {} now; raise GLARK_MAX_LEVEL or max-level",
                    context.level, context.max_level));
    context.level = context.max_level;
  } else {
    context.max_level = context.level;
  }
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
  settings.leave_alone = makes_its_own_calls(names);
  read_configuration_file(environment, names, parsed);
  if (const auto enable = find_variable(environment, variable::enable); enable && !enable->empty()) {
    if (const std::optional<bool> wanted = parse_switch(*enable))
      settings.context.transparent = *wanted;
    else
      parsed.problems.push_back(fmt::format("{} is \"{}\"; 0 or 1 is needed", variable::enable, *enable));
  }
  read_variables(environment, parsed);
  limit_level(parsed);
  if (settings.context.measure.budget > 0 && !settings.context.measure.on())
    parsed.problems.emplace_back("GLARK_BUDGET has no effect without GLARK_EDGE_PIXELS or GLARK_CURVATURE");
  for (const core::RefinementTraits& row : core::refinements) {
    const float number = settings.context.shape_numbers.at(static_cast<std::size_t>(row.refinement));
    if (number != row.number.initial && settings.context.refinement != row.refinement)
      parsed.problems.push_back(fmt::format("{} has no effect without GLARK_REFINE={}", row.number.variable, row.word));
  }
  if (settings.context.geomorph && !settings.context.measure.on())
    parsed.problems.emplace_back("GLARK_GEOMORPH has no effect without GLARK_EDGE_PIXELS or GLARK_CURVATURE");
  settings.context.transparent = settings.context.transparent && !settings.leave_alone;
  settings.context.read_counts = !settings.statistics_file.empty();
  if (settings.everything) {
    settings.context.left_draws = 0;
    settings.context.left_shaders.clear();
  }
  return parsed;
}

}  // namespace glark::settings
