// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/text_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "glark/clients/geometry/read/points/point_builder.h"
#include "glark/clients/geometry/read/points/point_counter.h"

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

// Tells normals from colours: all normals have length 1 or 0, or one has a negative number.
class NormalJudge {
 public:
  void see(const std::array<float, 3>& normal) {
    const float square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
    if (!std::isfinite(normal[0]) || !std::isfinite(normal[1]) || !std::isfinite(normal[2])) return;
    if (square != 0 && !(square > 0.9F && square < 1.1F)) have_unit_length_ = false;
    if (normal[0] < 0 || normal[1] < 0 || normal[2] < 0) any_negative_ = true;
  }
  bool are_colours() const { return !have_unit_length_ && !any_negative_; }

 private:
  bool have_unit_length_ = true;
  bool any_negative_ = false;
};

// Sink: PointBuilder or PointCounter.
template <class Sink>
class Lines {
 public:
  Lines(Input& input, TextPoints kind, const ReadOptions& options) : input_(input), kind_(kind), options_(options) {}

  typename Sink::Result read() {
    std::string_view line;
    while (input_.line(line)) {
      constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
      if (++number_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
      if (is_comment(line)) continue;
      add(TextRow(line), line);
    }
    if (!sink_) throw Error(input_.name() + ": it has no points; check the format or export it again");
    if (announced_ && *announced_ > points_)
      throw Error(fmt::format("{}: the first line announces {} points, {} follow; the file is cut off, get it again",
                              input_.name(), *announced_, points_));
    if (announced_ && *announced_ < points_)
      sink_->warn(fmt::format("the first line announces {} points, {} follow; all are kept", *announced_, points_));
    if (columns_->intensity) sink_->warn("the intensity is not kept");
    if (columns_->normal_may_be_colour() && judge_.are_colours()) sink_->make_colours_of_normals();
    return sink_->finish();
  }

 private:
  std::string place() const { return fmt::format("{}: line {}", input_.name(), number_); }

  void add(const TextRow& row, std::string_view line) {
    const bool first = !sink_;
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
      sink_.emplace(input_.name(), "point", attributes_of(*columns_), options_, ColourRange::by_greatest);
      if (announced_) sink_->expect(*announced_, 0);
    }
    if (row.count != columns_->count)
      throw Error(fmt::format("{}: {} columns, the lines before have {}; the file is cut off or damaged, get it again",
                              place(), row.count, columns_->count));
    const Point point = point_of(row, *columns_);
    judge_.see(point.normal);
    sink_->add_point(point, true);
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
  NormalJudge judge_;
  std::optional<Sink> sink_;
};

}  // namespace

Reading read_text_points(Input& input, TextPoints kind, const ReadOptions& options) {
  return Lines<PointBuilder>(input, kind, options).read();
}

Summary summarise_text_points(Input& input, TextPoints kind, const ReadOptions& options) {
  return Lines<PointCounter>(input, kind, options).read();
}

}  // namespace glark::geometry
