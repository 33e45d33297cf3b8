// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/edit/configuration_edit.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "glark/settings/configuration.h"
#include "glark/settings/table.h"

namespace glark::settings {
namespace {

namespace fs = std::filesystem;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

// TOML 1.0: bare keys have letters, digits, '_' and '-'; others are quoted.
std::string toml_key(std::string_view name) {
  const auto bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (!name.empty() && std::all_of(name.begin(), name.end(), bare)) return std::string(name);
  std::string text = "\"";
  for (const char letter : name) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter;
  }
  return text + '"';
}

std::vector<std::string> edited_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

bool is_table_header(std::string_view line) { return trimmed(line).starts_with('['); }

// Returns whether the line is the header of this table, written in one of the usual ways.
bool is_header_of(std::string_view line, std::string_view program) {
  std::string_view header = trimmed(line.substr(0, line.find('#')));
  if (!header.starts_with('[') || !header.ends_with(']') || header.starts_with("[[")) return false;
  header = trimmed(header.substr(1, header.size() - 2));
  return header == fmt::format("program.{}", toml_key(program)) || header == fmt::format("program.\"{}\"", program) ||
         header == fmt::format("program.'{}'", program);
}

bool sets(std::string_view line, std::string_view key) {
  const std::size_t equals = line.find('=');
  return equals != std::string_view::npos && trimmed(line.substr(0, equals)) == key;
}

void set_in_table(std::vector<std::string>& lines, std::size_t header, const ChangedSetting& setting) {
  const auto first = lines.begin() + static_cast<std::ptrdiff_t>(header) + 1;
  const auto end = std::find_if(first, lines.end(), [](const std::string& line) { return is_table_header(line); });
  const auto found = std::find_if(first, end, [&](const std::string& line) { return sets(line, setting.key); });
  const std::string text = fmt::format("{} = {}", setting.key, setting.value);
  if (found != end)
    *found = text;
  else
    lines.insert(first, text);
}

// Applies the text and returns how the program would be refined.
std::optional<core::ContextOptions> meaning_of(const std::string& text, const std::string& program,
                                               std::size_t& problems) {
  Settings settings;
  apply_defaults(settings);
  std::vector<std::string> sentences;
  const std::vector<std::string> names{program};
  apply_configuration(text, "", names, settings, sentences);
  problems = sentences.size();
  return settings.context;
}

bool means(const std::string& text, const std::string& before, const std::string& program,
           std::span<const ChangedSetting> changed, std::span<const core::DrawRule> rules) {
  std::size_t old_problems = 0;
  std::size_t problems = 0;
  meaning_of(before, program, old_problems);
  const std::optional<core::ContextOptions> read = meaning_of(text, program, problems);
  if (problems > old_problems || (is_toml(before) && !is_toml(text))) return false;
  Settings expected;
  expected.context = *read;
  for (const ChangedSetting& setting : changed) {
    std::string value = setting.value;
    std::erase(value, '"');
    give(*find_setting(setting.key), expected, value);
  }
  const bool has_rules = std::all_of(rules.begin(), rules.end(), [&](const core::DrawRule& rule) {
    return std::find(read->rules.begin(), read->rules.end(), rule) != read->rules.end();
  });
  return has_rules && changed_settings(*read, expected.context).empty();
}

std::string cannot(const std::string& file, std::string_view reason) {
  return fmt::format("{} cannot be written: {}; it is not changed", file, reason);
}

// Writes another file and renames it, so that a reader never sees half a file. A link stays a link.
std::string replace(const std::string& named, const std::string& text) {
  std::error_code error;
  const fs::path file = fs::exists(named, error) ? fs::canonical(named, error) : fs::path(named);
  const std::string aside = fmt::format("{}.{}", file.string(), getpid());
  errno = 0;
  {
    std::ofstream out(aside, std::ios::binary);
    out << text;
    if (!out.flush()) return cannot(named, errno != 0 ? std::strerror(errno) : "writing failed");
  }
  if (fs::exists(file, error)) fs::permissions(aside, fs::status(file, error).permissions(), error);
  fs::rename(aside, file, error);
  if (!error) return {};
  std::error_code ignored;
  fs::remove(aside, ignored);
  return cannot(named, error.message());
}

}  // namespace

std::string with_settings(std::string_view text, std::string_view program, std::span<const ChangedSetting> changed,
                          std::span<const core::DrawRule> rules) {
  std::vector<std::string> lines = edited_lines(text);
  const std::string table = "program." + toml_key(program);
  if (!changed.empty()) {
    auto header =
        std::find_if(lines.begin(), lines.end(), [&](const std::string& line) { return is_header_of(line, program); });
    if (header == lines.end()) {
      if (!lines.empty()) lines.emplace_back();
      header = lines.insert(lines.end(), fmt::format("[{}]", table));
    }
    const auto at = static_cast<std::size_t>(header - lines.begin());
    for (const ChangedSetting& setting : changed) set_in_table(lines, at, setting);
  }
  std::string edited;
  for (const std::string& line : lines) edited += line + '\n';
  for (const core::DrawRule& rule : rules)
    edited += fmt::format("{}[[{}.rule]]\n{}", edited.empty() ? "" : "\n", table, text_of_rule(rule));
  return edited;
}

std::string writable_configuration(const char* const* environment) {
  if (std::string file = find_configuration(environment); !file.empty() && access(file.c_str(), W_OK) == 0) return file;
  const auto named = find_variable(environment, variable::config);
  if (named && !named->empty()) return std::string(*named);
  const auto folder = find_variable(environment, "XDG_CONFIG_HOME");
  if (folder && folder->starts_with('/')) return std::string(*folder) + "/glark/glark.toml";
  const auto home = find_variable(environment, "HOME");
  return home && !home->empty() ? std::string(*home) + "/.config/glark/glark.toml" : std::string();
}

std::string write_configuration(const std::string& file, const std::string& program,
                                std::span<const ChangedSetting> changed, std::span<const core::DrawRule> rules) {
  if (file.empty()) return "no configuration can be written: HOME and XDG_CONFIG_HOME are not set";
  std::error_code error;
  std::string before;
  std::string problem;
  if (fs::exists(file, error)) {
    const std::optional<std::string> text = read_configuration(file, problem);
    if (!text) return problem;
    before = *text;
  } else {
    fs::create_directories(fs::path(file).parent_path(), error);
    if (error) return cannot(file, error.message());
  }
  const std::string text = with_settings(before, program, changed, rules);
  if (text.size() > longest_configuration || !means(text, before, program, changed, rules))
    return cannot(file, fmt::format("the lines for [program.{}] would not be read as they are meant; edit it by hand",
                                    toml_key(program)));
  return replace(file, text);
}

}  // namespace glark::settings
