// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace glark::edit {
namespace {

constexpr std::string_view blanks = " \t\r";

template <class Value>
bool reads_as(std::string_view word, Value& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

bool Words::at_end() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  return rest_.empty();
}

std::string_view Words::word(std::string_view name) {
  if (at_end()) throw BadWord(fmt::format("{} is missing", name));
  const std::string_view found = rest_.substr(0, rest_.find_first_of(blanks));
  rest_.remove_prefix(found.size());
  return found;
}

std::string Words::file(std::string_view name) {
  if (at_end() || rest_.front() != '"') return std::string(word(name));
  const std::size_t end = rest_.find('"', 1);
  if (end == std::string_view::npos) throw BadWord(fmt::format("{} has no quote at its end", name));
  std::string found(rest_.substr(1, end - 1));
  rest_.remove_prefix(end + 1);
  if (found.empty()) throw BadWord(fmt::format("{} is empty", name));
  return found;
}

double Words::number(std::string_view name) {
  const std::string_view text = word(name);
  double value = 0;
  if (!reads_as(text, value) || !std::isfinite(value))
    throw BadWord(fmt::format("{} is \"{}\", no number", name, text));
  return value;
}

double Words::above_zero(std::string_view name) {
  const double value = number(name);
  if (!(value > 0)) throw BadWord(fmt::format("{} is {}; it must be above 0", name, value));
  return value;
}

double Words::up_to_one(std::string_view name) {
  const double value = number(name);
  if (!(value >= 0 && value <= 1)) throw BadWord(fmt::format("{} is {}; 0 to 1 is possible", name, value));
  return value;
}

std::size_t Words::whole(std::string_view name, std::size_t most) {
  const std::string_view text = word(name);
  std::size_t value = 0;
  if (!reads_as(text, value) || value > most)
    throw BadWord(fmt::format("{} is \"{}\", no whole number from 0 to {}", name, text, most));
  return value;
}

Vector Words::vector(std::string_view name) {
  Vector result{};
  for (std::size_t k = 0; k < 3; ++k) result[k] = number(fmt::format("{}{}", name, "XYZ"[k]));
  return result;
}

Ball Words::ball() {
  const Vector centre = vector("");
  return {centre, above_zero("RADIUS")};
}

}  // namespace glark::edit
