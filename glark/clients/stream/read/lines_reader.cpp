// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/stream/read/stream_reader.h"

namespace glark::stream {
namespace {

using geometry::TextColumns;
using geometry::TextPoints;
using geometry::TextRow;

constexpr std::size_t rows_to_judge = 4096;  // they tell colours from normals, and fractions from bytes

double length(const TextRow& row, std::size_t column) {
  return std::hypot(row.values[column], row.values[column + 1], row.values[column + 2]);
}

class LinesReader final : public StreamReader {
 public:
  LinesReader(geometry::Input input, TextPoints kind, const ReadOptions& options)
      : StreamReader(std::move(input), "point", options), kind_(kind) {
    reading([&] { read_first_rows(); });
  }

  std::optional<std::uint64_t> count() const override { return announced_; }

  Points read(std::size_t most) override {
    return reading([&] {
      clear();
      const std::size_t wanted = std::max<std::size_t>(1, most);
      while (given_ < first_rows_.size() && arrays_.positions.size() < 3 * wanted) add_row(first_rows_[given_++]);
      if (given_ == first_rows_.size()) first_rows_.clear(), given_ = 0;
      while (arrays_.positions.size() < 3 * wanted) {
        const std::optional<TextRow> row = next_row();
        if (!row) break;
        add_row(*row);
      }
      if (arrays_.positions.empty() && announced_ && *announced_ > next_)
        throw Error(Element::file, 0,
                    fmt::format("{}: the first line announces {} points, {} follow; the file is cut off, get it again",
                                name(), *announced_, next_));
      return finish_block();
    });
  }

 private:
  std::string place() const { return fmt::format("{}: line {}", name(), line_); }

  // Returns the next line with numbers.
  std::optional<TextRow> next_row() {
    std::string_view line;
    while (input_.line(line)) {
      constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
      if (++line_ == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
      if (geometry::is_comment(line)) continue;
      const TextRow row(line);
      if (!row.numbers && line_ == 1) continue;  // the names of the columns
      if (!row.numbers)
        throw Error(Element::file, line_,
                    place() + ": \"" + std::string(line.substr(0, 40)) +
                        "\" is not a row of numbers; repair the file or check the format");
      if (geometry::may_have_decimal_commas(line))
        throw Error(Element::file, line_,
                    place() + ": \"" + std::string(line.substr(0, 40)) +
                        "\" has commas between digits and other separators; write decimal points, or separate by "
                        "commas only");
      if (columns_ && row.count != columns_->count)
        throw Error(
            Element::file, line_,
            fmt::format("{}: {} columns, the lines before have {}; the file is cut off or damaged, get it again",
                        place(), row.count, columns_->count));
      return row;
    }
    return std::nullopt;
  }

  void read_first_rows() {
    std::optional<TextRow> row = next_row();
    if (row && kind_ == TextPoints::pts && row->count == 1 && row->values[0] >= 0 && row->values[0] < 1e15) {
      announced_ = static_cast<std::uint64_t>(row->values[0]);
      row = next_row();
    }
    if (!row) throw Error(Element::file, 0, name() + ": it has no points; check the format or export it again");
    columns_.emplace(*row, kind_, place());
    for (; row; row = first_rows_.size() < rows_to_judge ? next_row() : std::nullopt) first_rows_.push_back(*row);
    judge();
    make_schema();
  }

  // Six columns of which none is negative, and some have not length 0 or 1, are a position and a colour.
  void judge() {
    if (columns_->normal_may_be_colour()) {
      const std::size_t column = *columns_->normal;
      const bool are_normals = std::all_of(first_rows_.begin(), first_rows_.end(), [&](const TextRow& row) {
        return std::abs(length(row, column) - 1) < 0.05 || length(row, column) == 0;
      });
      const bool any_negative = std::any_of(first_rows_.begin(), first_rows_.end(), [&](const TextRow& row) {
        return std::any_of(&row.values[column], &row.values[column] + 3, [](double value) { return value < 0; });
      });
      if (!are_normals && !any_negative) {
        columns_->colour = columns_->normal;
        columns_->normal.reset();
      }
    }
    if (!columns_->colour) return;
    const std::size_t column = *columns_->colour;
    const bool are_bytes = std::any_of(first_rows_.begin(), first_rows_.end(), [&](const TextRow& row) {
      return std::any_of(&row.values[column], &row.values[column] + 3, [](double value) { return value > 1; });
    });
    colour_scale_ = are_bytes ? 1 : 255;
  }

  void make_schema() {
    schema_.position = Number::float64;
    schema_.normals = columns_->normal.has_value() && options_.normals;
    if (!options_.channels) return;
    if (columns_->intensity) schema_.channels.push_back({"intensity", Number::float32});
    if (columns_->colour)
      for (const char* channel : {"red", "green", "blue"}) schema_.channels.push_back({channel, Number::uint8});
  }

  void add_row(const TextRow& row) {
    channels_.clear();
    std::array<float, 3> normal{};
    if (columns_->intensity) channels_.push_back(row.values[*columns_->intensity]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (columns_->colour)
        channels_.push_back(std::clamp(colour_scale_ * row.values[*columns_->colour + k], 0.0, 255.0));
      if (columns_->normal) normal[k] = static_cast<float>(row.values[*columns_->normal + k]);
    }
    add(row.values.data(), normal.data(), channels_);
  }

  TextPoints kind_;
  std::uint64_t line_ = 0;
  std::optional<std::uint64_t> announced_;
  std::optional<TextColumns> columns_;
  double colour_scale_ = 1;
  std::vector<TextRow> first_rows_;
  std::size_t given_ = 0;
  std::vector<double> channels_;
};

}  // namespace

std::unique_ptr<PointReader> lines_reader(geometry::Input input, TextPoints kind, const ReadOptions& options) {
  return std::make_unique<LinesReader>(std::move(input), kind, options);
}

}  // namespace glark::stream
