// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/parse/text_row.h"

#include <fmt/format.h>

#include <fast_float/fast_float.h>

#include <cmath>
#include <limits>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {
namespace {

bool is_separator(char letter) {
  return letter == ' ' || letter == '\t' || letter == ',' || letter == ';' || letter == '\r';
}

bool is_byte(double value) { return value >= 0 && value <= 255 && value == std::floor(value); }

}  // namespace

TextRow::TextRow(std::string_view line) {
  const char* next = line.data();
  const char* const end = next + line.size();
  while (numbers) {
    while (next < end && is_separator(*next)) ++next;
    if (next == end) break;
    if (*next == '+') ++next;
    double value = 0;
    const auto [after, error] = fast_float::from_chars(next, end, value);
    if (error == std::errc::result_out_of_range) value = std::numeric_limits<double>::infinity();
    numbers =
        (error == std::errc() || error == std::errc::result_out_of_range) && (after == end || is_separator(*after));
    if (numbers && count < most_columns) values[count] = value;
    ++count;
    next = after;
  }
}

bool may_have_decimal_commas(std::string_view line) {
  const auto digit = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  bool within = false, other = line.find(';') != std::string_view::npos;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (line[i] == ',') within |= digit(i - 1) && digit(i + 1);
    if (line[i] == ' ' || line[i] == '\t') other |= !is_separator(line[i - 1]) && !is_separator(line[i + 1]);
  }
  return within && other;
}

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  return begin == std::string_view::npos || line[begin] == '#' || line.substr(begin).starts_with("//");
}

TextColumns::TextColumns(const TextRow& first, TextPoints kind, const std::string& place) : count(first.count) {
  const auto bytes_from = [&](std::size_t column) {
    return is_byte(first.values[column]) && is_byte(first.values[column + 1]) && is_byte(first.values[column + 2]);
  };
  if (count == 4 || count == 7 || count == 10) intensity = 3;
  switch (count) {
    case 3:
    case 4: break;
    case 6: (kind == TextPoints::pts ? colour : normal) = 3; break;
    case 7: colour = 4; break;
    case 9:
      colour = bytes_from(3) || !bytes_from(6) ? 3 : 6;
      normal = 9 - *colour;
      break;
    case 10:
      colour = 4;
      normal = 7;
      break;
    default:
      throw Error(
          fmt::format("{}: {} columns; 3 (x y z), 4 (and intensity), 6 (and colour or normal), 7 (intensity, "
                      "colour), 9 or 10 (colour and normal) can be read, export it so",
                      place, count));
  }
}

}  // namespace glark::geometry
