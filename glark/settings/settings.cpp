// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "glark/settings/configuration.h"
#include "glark/settings/idle_settings.h"
#include "glark/settings/names/nearest_name.h"
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
    if (text && !text->empty() && !give(setting, parsed.settings, *text))
      parsed.problems.push_back(wrong_value(setting.variable, *text, setting.needed));
  }
}

// A level above the default limit raises the limit. A limit that the user set lowers the level.
void limit_level(Parsed& parsed) {
  core::ContextOptions& context = parsed.settings.context;
  if (context.level <= context.max_level) return;
  if (parsed.settings.is_given("max-level")) {
    parsed.problems.push_back(fmt::format("--level {0} exceeds --max-level {1}; level {1} is used; raise --max-level",
                                          context.level, context.max_level));
    context.level = context.max_level;
  } else {
    context.max_level = context.level;
  }
}

// A misspelt variable would have no effect.
void find_unknown_variables(const char* const* environment, std::vector<std::string>& problems) {
  std::vector<std::string_view> known{variable::enable, variable::library};
  for (const Setting& setting : table()) known.emplace_back(setting.variable);
  for (; environment != nullptr && *environment != nullptr; ++environment) {
    const std::string_view entry = *environment;
    const std::string_view name = entry.substr(0, entry.find('='));
    if (!name.starts_with("GLARK_") || std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string_view nearest = nearest_name(name, known);
    problems.push_back(
        nearest.empty() ? fmt::format("{} is not a variable of glark and has no effect; man glark lists them", name)
                        : fmt::format("{} is not a variable of glark and has no effect; is {} meant?", name, nearest));
  }
}

void find_idle(Parsed& parsed) {
  const std::vector<std::string> idle = idle_settings(parsed.settings);
  parsed.problems.insert(parsed.problems.end(), idle.begin(), idle.end());
}

// Without GLARK_ENABLE, only programs that call the extension are refined, and they choose these themselves.
void find_disabled(Parsed& parsed) {
  for (const std::string_view key : {"level", "edge-pixels", "screen-error", "curvature", "refine"}) {
    if (!parsed.settings.is_given(key)) continue;
    parsed.problems.push_back(fmt::format("{} has no effect without {}=1 on a program that does not call the extension",
                                          find_setting(key)->variable, variable::enable));
    return;
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
  apply_defaults(settings);
  settings.leave_alone = makes_its_own_calls(names);
  read_configuration_file(environment, names, parsed);
  // A variable must not make a setting of the file a mistake: the file is judged alone.
  if (!settings.leave_alone) find_idle(parsed);
  std::set<std::string_view> in_file = std::exchange(settings.given, {});
  if (const auto enable = find_variable(environment, variable::enable); enable && !enable->empty()) {
    if (const std::optional<bool> wanted = parse_switch(*enable))
      settings.context.transparent = *wanted;
    else
      parsed.problems.push_back(wrong_value(variable::enable, *enable, "0 or 1"));
  }
  read_variables(environment, parsed);
  find_unknown_variables(environment, parsed.problems);
  find_idle(parsed);
  if (!find_variable(environment, variable::enable)) find_disabled(parsed);
  settings.given.merge(in_file);
  limit_level(parsed);
  settings.context.transparent = settings.context.transparent && !settings.leave_alone;
  settings.context.read_counts = !settings.statistics_file.empty();
  settings.context.wait = settings.context.wait || !settings.captures.empty();  // the same pictures in each run
  if (settings.everything) {
    settings.context.left_draws = 0;
    settings.context.left_shaders.clear();
    std::erase_if(settings.context.rules, [](const core::DrawRule& rule) { return !rule.refinement; });
  }
  return parsed;
}

}  // namespace glark::settings
