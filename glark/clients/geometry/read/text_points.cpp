// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/text_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "glark/clients/geometry/read/point_builder.h"

namespace glark::geometry {
namespace {

Attributes attributes_of(const TextColumns& columns) {
  return {columns.normal.has_value(), columns.colour.has_value(), false};
}

Point point_of(const TextRow& row, const TextColumns& columns) {
  Point point;
  std::copy_n(row.values.begin(), 3, point.position.begin());
  for (std::size_t i = 0; i < 3; ++i) {
    if (columns.normal) point.normal[i] = static_cast<float>(row.values[*columns.normal + i]);
    if (columns.colour) point.colour[i] = static_cast<float>(row.values[*columns.colour + i]);
  }
  return point;
}

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

class Lines {
 public:
  Lines(Input& input, TextPoints kind, const ReadOptions& options) : input_(input), kind_(kind), options_(options) {}

  Reading read() {
    std::string_view line;
    while (input_.line(line)) {
      constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
      if (++number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
      if (is_comment(line)) continue;
      add(TextRow(line), line);
    }
    if (!builder_) throw Error(input_.name() + ": it has no points; check the format or export it again");
    if (announced_ && *announced_ > points_)
      throw Error(fmt::format("{}: the first line announces {} points, {} follow; the file is cut off, get it again",
                              input_.name(), *announced_, points_));
    if (announced_ && *announced_ < points_)
      builder_->warn(fmt::format("the first line announces {} points, {} follow; all are kept", *announced_, points_));
    if (columns_->intensity) builder_->warn("the intensity is not kept");
    Reading reading = builder_->finish();
    if (columns_->normal_may_be_colour() && !reading.geometry.normals.empty() &&
        !have_unit_length(reading.geometry.normals) && !any_negative(reading.geometry.normals))
      make_colours_of_normals(reading.geometry);
    return reading;
  }

 private:
  std::string place() const { return fmt::format("{}: line {}", input_.name(), number_); }

  void add(const TextRow& row, std::string_view line) {
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
      builder_.emplace(input_.name(), "point", attributes_of(*columns_), options_, ColourRange::by_greatest);
      if (announced_) builder_->expect(*announced_, 0);
    }
    if (row.count != columns_->count)
      throw Error(fmt::format("{}: {} columns, the lines before have {}; the file is cut off or damaged, get it again",
                              place(), row.count, columns_->count));
    builder_->add_point(point_of(row, *columns_), true);
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
  std::optional<TextColumns> columns_;
  std::optional<PointBuilder> builder_;
};

}  // namespace

Reading read_text_points(Input& input, TextPoints kind, const ReadOptions& options) {
  return Lines(input, kind, options).read();
}

}  // namespace glark::geometry
