// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A line of numbers in a text file of points, and the meaning of its columns.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glark::geometry {

enum class TextPoints {
  // Six columns are a position and a normal if all normals have length 1 or 0, or if a number is negative. Otherwise
  // they are a position and a colour.
  xyz,
  // The first line may be the number of points. Six columns are a position and a colour.
  pts,
};

// The numbers of a line. `numbers` is false if a word is not a number.
struct TextRow {
  static constexpr std::size_t most_columns = 10;
  std::array<double, most_columns> values{};
  std::size_t count = 0;
  bool numbers = true;

  explicit TextRow(std::string_view line);
};

// Which columns have the position, the intensity, the colour and the normal. The position comes first.
struct TextColumns {
  std::size_t count = 0;
  std::optional<std::size_t> intensity, colour, normal;

  // Decides by the first row. Throws Error, which names the place, for a number of columns without a meaning.
  TextColumns(const TextRow& first, TextPoints kind, const std::string& place);
  bool normal_may_be_colour() const { return count == 6 && normal.has_value(); }
};

// Returns whether commas may be decimal commas, as in "1,5 2,5" or "1,5;2,5". The numbers must have other separators.
bool may_have_decimal_commas(std::string_view line);
// Returns whether the line has no numbers: it is empty, or begins with # or //.
bool is_comment(std::string_view line);

}  // namespace glark::geometry
