// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "glark/settings/settings.h"

namespace glark::settings {
namespace {

std::optional<unsigned> parse_number(std::string_view text) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<float> parse_decimal(std::string_view text, float least, float most) {
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && value >= least && value <= most ? std::optional<float>(value) : std::nullopt;
}

// Returns the length of the file name that `text` begins with.
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

// Calls `take` with each word of a comma-separated list, without blanks around it. Returns false if `take` did for a
// word, or if a word is empty.
template <class Take>
bool for_each_word(std::string_view text, const Take& take) {
  if (text.find_first_not_of(' ') == std::string_view::npos) return true;  // the empty list
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    std::string_view word = text.substr(0, comma);
    more = comma != std::string_view::npos;
    text.remove_prefix(more ? comma + 1 : text.size());
    const std::size_t first = word.find_first_not_of(' ');
    if (first == std::string_view::npos) return false;
    word = word.substr(first, word.find_last_not_of(' ') + 1 - first);
    if (!take(word)) return false;
  }
  return true;
}

struct NamedRule {
  std::string_view name;
  unsigned bits;
};

constexpr std::array<NamedRule, 7> rules{{{"screen-quads", core::left_draws::screen_quads},
                                          {"overlays", core::left_draws::overlays},
                                          {"orthographic", core::left_draws::orthographic},
                                          {"blended", core::left_draws::blended},
                                          {"no-depth-test", core::left_draws::no_depth_test},
                                          {"no-depth-writes", core::left_draws::no_depth_writes},
                                          {"none", 0}}};

}  // namespace

std::optional<unsigned> parse_level(std::string_view text) {
  const std::optional<unsigned> level = parse_number(text);
  return level && *level <= core::max_supported_level ? level : std::nullopt;
}

std::optional<core::Refinement> parse_refinement(std::string_view text) {
  const auto* const row =
      std::find_if(core::refinements.begin(), core::refinements.end(),
                   [&](const core::RefinementTraits& refinement) { return refinement.word == text; });
  return row != core::refinements.end() ? std::optional(row->refinement) : std::nullopt;
}

std::optional<float> parse_shape_number(const core::ShapeNumber& number, std::string_view text) {
  return parse_decimal(text, number.least, number.most);
}

std::optional<float> parse_edge_pixels(std::string_view text) {
  return text == "0" ? std::optional<float>(0) : parse_decimal(text, 0.5F, 10000);
}

std::optional<float> parse_curvature(std::string_view text) {
  return text == "0" ? std::optional<float>(0) : parse_decimal(text, 0.5F, 180);
}

std::optional<float> parse_screen_error(std::string_view text) {
  return text == "0" ? std::optional<float>(0) : parse_decimal(text, 0.01F, 1000);
}

std::optional<float> parse_crease(std::string_view text) { return parse_decimal(text, 0, 180); }

std::optional<unsigned> parse_budget(std::string_view text) {
  const std::optional<unsigned> triangles = parse_number(text);
  return triangles && *triangles <= 1000000000 ? triangles : std::nullopt;
}

std::optional<std::uint64_t> parse_megabytes(std::string_view text) {
  const std::optional<unsigned> number = parse_number(text);
  return number && *number <= 65536 ? std::optional(std::uint64_t{*number} << 20) : std::nullopt;
}

std::optional<bool> parse_polygons(std::string_view text) {
  if (text == "triangles") return false;
  if (text == "centroid") return true;
  return std::nullopt;
}

std::optional<bool> parse_normals(std::string_view text) {
  if (text == "given") return false;
  if (text == "geometry") return true;
  return std::nullopt;
}

std::optional<core::LogLevel> parse_log_level(std::string_view text) {
  if (text == "error") return core::LogLevel::error;
  if (text == "warning") return core::LogLevel::warning;
  if (text == "info") return core::LogLevel::info;
  if (text == "debug") return core::LogLevel::debug;
  return std::nullopt;
}

std::optional<bool> parse_switch(std::string_view text) {
  if (text == "1" || text == "true") return true;
  if (text == "0" || text == "false") return false;
  return std::nullopt;
}

std::optional<const Key*> parse_key(std::string_view text) {
  const Key* const key = find_key(text);
  return key != nullptr || text == "none" ? std::optional(key) : std::nullopt;
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

std::optional<unsigned> parse_left_draws(std::string_view text) {
  unsigned bits = 0;
  const bool known = for_each_word(text, [&](std::string_view word) {
    const auto* const rule =
        std::find_if(rules.begin(), rules.end(), [&](const NamedRule& named) { return named.name == word; });
    if (rule == rules.end()) return false;
    bits |= rule->bits;
    return true;
  });
  return known ? std::optional(bits) : std::nullopt;
}

std::optional<std::vector<std::uint64_t>> parse_hashes(std::string_view text) {
  std::vector<std::uint64_t> hashes;
  const bool valid = for_each_word(text, [&](std::string_view word) {
    std::uint64_t hash = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), hash, 16);
    if (word.size() != 16 || error != std::errc{} || end != word.data() + word.size()) return false;
    hashes.push_back(hash);
    return true;
  });
  return valid ? std::optional(std::move(hashes)) : std::nullopt;
}

std::optional<std::string> parse_attribute(std::string_view text) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  if (text.empty() || text.size() > 1024 || !std::all_of(text.begin(), text.end(), allowed)) return std::nullopt;
  const bool number = std::isdigit(static_cast<unsigned char>(text[0])) != 0;
  if (number && !parse_number(text)) return std::nullopt;
  return std::string(text);
}

}  // namespace glark::settings
