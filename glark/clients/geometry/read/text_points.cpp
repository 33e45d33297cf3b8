// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/text_points.h"

#include <fmt/format.h>

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "glark/clients/geometry/read/point_builder.h"

namespace glark::geometry {
namespace {

constexpr std::size_t most_columns = 10;

bool is_separator(char letter) {
  return letter == ' ' || letter == '\t' || letter == ',' || letter == ';' || letter == '\r';
}

// The numbers of a line. `numbers` is false if a word is not a number.
struct Row {
  std::array<double, most_columns> values{};
  std::size_t count = 0;
  bool numbers = true;

  explicit Row(std::string_view line) {
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
};

// Returns whether commas may be decimal commas, as in "1,5 2,5" or "1,5;2,5". The numbers must have other separators.
bool may_have_decimal_commas(std::string_view line) {
  const auto digit = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  bool within = false, other = line.find(';') != std::string_view::npos;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (line[i] == ',') within |= digit(i - 1) && digit(i + 1);
    if (line[i] == ' ' || line[i] == '\t') other |= !is_separator(line[i - 1]) && !is_separator(line[i + 1]);
  }
  return within && other;
}

bool is_byte(double value) { return value >= 0 && value <= 255 && value == std::floor(value); }

class Columns {
 public:
  Columns(const Row& first, TextPoints kind, const std::string& place) {
    count_ = first.count;
    const auto bytes_from = [&](std::size_t column) {
      return is_byte(first.values[column]) && is_byte(first.values[column + 1]) && is_byte(first.values[column + 2]);
    };
    switch (count_) {
      case 3:
      case 4: break;  // column 4 is an intensity
      case 6: (kind == TextPoints::pts ? colour_ : normal_) = 3; break;
      case 7: colour_ = 4; break;
      case 9:
        colour_ = bytes_from(3) || !bytes_from(6) ? 3 : 6;
        normal_ = 9 - *colour_;
        break;
      case 10:
        colour_ = 4;
        normal_ = 7;
        break;
      default:
        throw Error(
            fmt::format("{}: {} columns; 3 (x y z), 4 (and intensity), 6 (and colour or normal), 7 (intensity, "
                        "colour), 9 or 10 (colour and normal) can be read, export it so",
                        place, count_));
    }
  }

  std::size_t count() const { return count_; }
  bool has_intensity() const { return count_ == 4 || count_ == 7 || count_ == 10; }
  bool normal_may_be_colour() const { return count_ == 6 && normal_.has_value(); }
  Attributes attributes() const { return {normal_.has_value(), colour_.has_value(), false}; }

  Point point(const Row& row) const {
    Point point;
    std::copy_n(row.values.begin(), 3, point.position.begin());
    for (std::size_t i = 0; i < 3; ++i) {
      if (normal_) point.normal[i] = static_cast<float>(row.values[*normal_ + i]);
      if (colour_) point.colour[i] = static_cast<float>(row.values[*colour_ + i]);
    }
    return point;
  }

 private:
  std::size_t count_ = 0;
  std::optional<std::size_t> normal_;
  std::optional<std::size_t> colour_;
};

bool have_unit_length(const std::vector<float>& normals) {
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    const float square = normals[i] * normals[i] + normals[i + 1] * normals[i + 1] + normals[i + 2] * normals[i + 2];
    if (square != 0 && !(square > 0.9F && square < 1.1F)) return false;
  }
  return true;
}

bool any_negative(const std::vector<float>& values) {
  return std::any_of(values.begin(), values.end(), [](float value) { return value < 0; });
}

void make_colours_of_normals(Geometry& geometry) {
  const std::size_t points = geometry.point_count();
  const bool are_fractions =
      std::all_of(geometry.normals.begin(), geometry.normals.end(), [](float n) { return n <= 1; });
  const float scale = are_fractions ? 255.0F : 1.0F;
  geometry.colours.assign(4 * points, 255);
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      geometry.colours[4 * i + k] =
          static_cast<std::uint8_t>(std::lround(std::clamp(scale * geometry.normals[3 * i + k], 0.0F, 255.0F)));
  geometry.normals = {};
}

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  return begin == std::string_view::npos || line[begin] == '#' || line.substr(begin).starts_with("//");
}

class Lines {
 public:
  Lines(Input& input, TextPoints kind, const ReadOptions& options) : input_(input), kind_(kind), options_(options) {}

  Reading read() {
    std::string_view line;
    while (input_.line(line)) {
      constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
      if (++number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
      if (is_comment(line)) continue;
      add(Row(line), line);
    }
    if (!builder_) throw Error(input_.name() + ": it has no points; check the format or export it again");
    if (announced_ && *announced_ > points_)
      throw Error(fmt::format("{}: the first line announces {} points, {} follow; the file is cut off, get it again",
                              input_.name(), *announced_, points_));
    if (announced_ && *announced_ < points_)
      builder_->warn(fmt::format("the first line announces {} points, {} follow; all are kept", *announced_, points_));
    if (columns_->has_intensity()) builder_->warn("the intensity is not kept");
    Reading reading = builder_->finish();
    if (columns_->normal_may_be_colour() && !reading.geometry.normals.empty() &&
        !have_unit_length(reading.geometry.normals) && !any_negative(reading.geometry.normals))
      make_colours_of_normals(reading.geometry);
    return reading;
  }

 private:
  std::string place() const { return fmt::format("{}: line {}", input_.name(), number_); }

  void add(const Row& row, std::string_view line) {
    const bool first = !builder_;
    if (first && !announced_ && kind_ == TextPoints::pts && row.numbers && row.count == 1 && row.values[0] >= 0 &&
        row.values[0] < 1e15) {
      announce(row.values[0]);
      return;
    }
    if (!row.numbers && first && number_ == 1) return;  // skips the names of the columns
    if (!row.numbers)
      throw Error(place() + ": \"" + std::string(line.substr(0, 40)) +
                  "\" is not a row of numbers; repair the file or check the format");
    if (may_have_decimal_commas(line))
      throw Error(
          place() + ": \"" + std::string(line.substr(0, 40)) +
          "\" has commas between digits and other separators; write decimal points, or separate by commas only");
    if (first) {
      columns_.emplace(row, kind_, place());
      builder_.emplace(input_.name(), "point", columns_->attributes(), options_, ColourRange::by_greatest);
      if (announced_) builder_->expect(*announced_, 0);
    }
    if (row.count != columns_->count())
      throw Error(fmt::format("{}: {} columns, the lines before have {}; the file is cut off or damaged, get it again",
                              place(), row.count, columns_->count()));
    builder_->add_point(columns_->point(row), true);
    ++points_;
  }

  void announce(double count) {
    announced_ = static_cast<std::uint64_t>(count);
    // The shortest line, "0 0 0" and its end, has six bytes.
    if (const std::optional<std::uint64_t> left = input_.remaining();
        left && count * 6 > static_cast<double>(*left) + 1)
      throw Error(
          fmt::format("{}: it announces {} points, for which the file is too short; it is cut off, get it again",
                      place(), *announced_));
  }

  Input& input_;
  TextPoints kind_;
  const ReadOptions& options_;
  std::uint64_t number_ = 0;
  std::uint64_t points_ = 0;
  std::optional<std::uint64_t> announced_;
  std::optional<Columns> columns_;
  std::optional<PointBuilder> builder_;
};

}  // namespace

Reading read_text_points(Input& input, TextPoints kind, const ReadOptions& options) {
  return Lines(input, kind, options).read();
}

}  // namespace glark::geometry
