// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/settings/settings.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace glark::settings {
namespace {

static_assert(core::max_supported_level == 11, "needed_level() names the limit");

std::optional<unsigned> parse_number(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Decimal, without a sign, an exponent or the locale's comma.
std::optional<float> parse_decimal(std::string_view text, float least, float most) {
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && value >= least && value <= most ? std::optional<float>(value) : std::nullopt;
}

std::optional<std::string_view> find(const char* const* environment, std::string_view name) {
  for (; environment != nullptr && *environment != nullptr; ++environment) {
    const std::string_view entry = *environment;
    if (entry.size() > name.size() && entry[name.size()] == '=' && entry.starts_with(name))
      return entry.substr(name.size() + 1);
  }
  return std::nullopt;
}

// One variable: absent or empty leaves `setting` alone.
template <class T>
void read(Parsed& parsed, const char* const* environment, const char* name,
          std::optional<T> (*parse_value)(std::string_view), std::string_view needed, T& setting) {
  const std::optional<std::string_view> text = find(environment, name);
  if (!text || text->empty()) return;
  if (std::optional<T> value = parse_value(*text))
    setting = std::move(*value);
  else
    parsed.problems.push_back(std::string(name) + " is \"" + std::string(*text) + "\"; " + std::string(needed) +
                              " is needed");
}

// The end of the file name that starts at `text`: its length.
std::size_t file_name_length(std::string_view text) {
  for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
    const std::size_t after = text.find_first_not_of("0123456789", comma + 1);
    if (after != std::string_view::npos && after > comma + 1 && text[after] == ':') return comma;
  }
  return text.size();
}

std::optional<CaptureRequest> parse_capture(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::optional<unsigned> frame = parse_number(text.substr(0, colon));
  const std::string_view file = text.substr(colon + 1);
  if (!frame || *frame == 0 || !file.ends_with(".png") || file.size() <= 4) return std::nullopt;
  return CaptureRequest{*frame, std::string(file)};
}

}  // namespace

std::string_view needed_level() { return "an integer from 0 to 11"; }
std::string_view needed_refinement() { return "linear, outputs or pn"; }
std::string_view needed_edge_pixels() { return "a number from 0.5 to 10000, or 0 for none,"; }
std::string_view needed_curvature() { return "degrees from 0.5 to 180, or 0 for none,"; }
std::string_view needed_budget() { return "a number of triangles up to 1000000000, or 0 for none,"; }
std::string_view needed_log_level() { return "error, warning, info or debug"; }
std::string_view needed_switch() { return "0 or 1"; }
std::string_view needed_captures() { return "FRAME:FILE.png, with frames counted from 1,"; }

std::optional<unsigned> parse_level(std::string_view text) {
  const std::optional<unsigned> level = parse_number(text);
  return level && *level <= core::max_supported_level ? level : std::nullopt;
}

std::optional<core::Refinement> parse_refinement(std::string_view text) {
  if (text == "linear") return core::Refinement::linear_inputs;
  if (text == "outputs") return core::Refinement::linear_outputs;
  if (text == "pn") return core::Refinement::pn;
  return std::nullopt;
}

std::optional<float> parse_edge_pixels(std::string_view text) {
  return text == "0" ? std::optional<float>(0) : parse_decimal(text, 0.5F, 10000);
}

std::optional<float> parse_curvature(std::string_view text) {
  return text == "0" ? std::optional<float>(0) : parse_decimal(text, 0.5F, 180);
}

std::optional<unsigned> parse_budget(std::string_view text) {
  const std::optional<unsigned> triangles = parse_number(text);
  return triangles && *triangles <= 1000000000 ? triangles : std::nullopt;
}

std::optional<core::LogLevel> parse_log_level(std::string_view text) {
  if (text == "error") return core::LogLevel::error;
  if (text == "warning") return core::LogLevel::warning;
  if (text == "info") return core::LogLevel::info;
  if (text == "debug") return core::LogLevel::debug;
  return std::nullopt;
}

std::optional<bool> parse_switch(std::string_view text) {
  if (text == "1") return true;
  if (text == "0") return false;
  return std::nullopt;
}

std::optional<std::vector<CaptureRequest>> parse_captures(std::string_view text) {
  std::vector<CaptureRequest> requests;
  while (!text.empty()) {
    const std::size_t length = file_name_length(text);
    std::optional<CaptureRequest> request = parse_capture(text.substr(0, length));
    if (!request) return std::nullopt;
    requests.push_back(std::move(*request));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return requests;
}

Parsed parse(const char* const* environment) {
  Parsed parsed;
  Settings& settings = parsed.settings;
  read(parsed, environment, variable::enable, parse_switch, needed_switch(), settings.context.transparent);
  read(parsed, environment, variable::level, parse_level, needed_level(), settings.context.level);
  read(parsed, environment, variable::max_level, parse_level, needed_level(), settings.context.max_level);
  read(parsed, environment, variable::refine, parse_refinement, needed_refinement(), settings.context.refinement);
  core::EdgeMeasure& measure = settings.context.measure;
  read(parsed, environment, variable::edge_pixels, parse_edge_pixels, needed_edge_pixels(), measure.pixels);
  read(parsed, environment, variable::curvature, parse_curvature, needed_curvature(), measure.degrees);
  read(parsed, environment, variable::budget, parse_budget, needed_budget(), measure.budget);
  if (measure.budget > 0 && !measure.on())
    parsed.problems.push_back(std::string(variable::budget) + " has no effect without " + variable::edge_pixels +
                              " or " + variable::curvature);
  read(parsed, environment, variable::wireframe, parse_switch, needed_switch(), settings.context.wireframe);
  read(parsed, environment, variable::log, parse_log_level, needed_log_level(), settings.log_level);
  read(parsed, environment, variable::capture, parse_captures, needed_captures(), settings.captures);
  if (const std::optional<std::string_view> file = find(environment, variable::statistics)) {
    settings.statistics_file = *file;
    settings.context.read_counts = true;
  }
  // A level that was asked for is reached: only a limit that was asked for as well holds it back.
  if (settings.context.level > settings.context.max_level) {
    if (find(environment, variable::max_level))
      parsed.problems.push_back(std::string(variable::level) + " is " + std::to_string(settings.context.level) +
                                ", more than " + variable::max_level + "; the level is " +
                                std::to_string(settings.context.max_level) + " now; raise " + variable::max_level);
    else
      settings.context.max_level = settings.context.level;
    settings.context.level = std::min(settings.context.level, settings.context.max_level);
  }
  return parsed;
}

}  // namespace glark::settings
