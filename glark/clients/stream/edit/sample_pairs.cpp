// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/edit/sample_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "glark/clients/stream/format/layout.h"

namespace glark::stream {
namespace {

constexpr std::size_t part = 1 << 14;  // samples that are read at a time

// All points of a file. A binary file tells their number at once.
std::size_t count_of(const std::filesystem::path& file) {
  const std::unique_ptr<PointReader> reader = open_points(file, {.normals = false, .channels = false});
  if (reader->count()) return static_cast<std::size_t>(*reader->count());
  std::size_t count = 0;
  for (Points points = reader->read(part); points.size() > 0; points = reader->read(part)) count += points.size();
  return count;
}

[[noreturn]] void fail_for_change(const std::filesystem::path& file) {
  throw Error(Element::file, 0, file.string() + ": was changed while it was read; start again");
}

// Reads the rows of a temporary file, a position and the channels each.
class RowReader final : public PointReader {
 public:
  RowReader(const TemporaryFile& file, std::string name, Schema schema, std::size_t count)
      : file_(file), name_(std::move(name)), schema_(std::move(schema)), count_(count) {}
  const std::string& name() const override { return name_; }
  const Schema& schema() const override { return schema_; }
  std::optional<std::uint64_t> count() const override { return count_; }
  bool can_seek() const override { return true; }
  void seek(std::uint64_t point) override { next_ = static_cast<std::size_t>(point); }
  Points read(std::size_t most) override {
    const std::size_t size = std::min(most, count_ - next_), width = schema_.channels.size(), row = 3 + width;
    rows_.resize(row * size);
    const std::span<double> rows(rows_);
    if (size > 0) file_.read(sizeof(double) * row * next_, {reinterpret_cast<char*>(rows.data()), rows.size_bytes()});
    positions_.clear();
    channels_.clear();
    for (std::size_t i = 0; i < size; ++i) {
      const std::span<double> own = rows.subspan(row * i, row);
      positions_.insert(positions_.end(), own.begin(), own.begin() + 3);
      channels_.insert(channels_.end(), own.begin() + 3, own.end());
    }
    next_ += size;
    return {next_ - size, positions_, {}, channels_};
  }

 private:
  const TemporaryFile& file_;
  std::string name_;
  Schema schema_;
  std::size_t count_, next_ = 0;
  std::vector<double> rows_, positions_, channels_;
};

// Writes rows to their places. Rows that follow one another are written together.
class RowWriter {
 public:
  RowWriter(TemporaryFile& file, std::size_t width) : file_(file), width_(width) {}

  void write(std::size_t place, std::span<const double> position, std::span<const double> channels) {
    if (place != begin_ + rows_.size() / width_ || rows_.size() >= width_ * part) flush(place);
    rows_.insert(rows_.end(), position.begin(), position.end());
    rows_.insert(rows_.end(), channels.begin(), channels.end());
  }
  void flush(std::size_t next) {
    const std::span<const double> rows(rows_);
    file_.write(sizeof(double) * width_ * begin_, {reinterpret_cast<const char*>(rows.data()), rows.size_bytes()});
    rows_.clear();
    begin_ = next;
  }

 private:
  TemporaryFile& file_;
  std::size_t width_, begin_ = 0;
  std::vector<double> rows_;
};

}  // namespace

void require_within_floats(std::span<const double> positions, std::uint64_t first, const std::string& file) {
  const auto beyond =
      std::find_if(positions.begin(), positions.end(), [](double at) { return !(std::abs(at) <= largest_coordinate); });
  if (beyond == positions.end()) return;
  const std::uint64_t point = first + static_cast<std::uint64_t>(beyond - positions.begin()) / 3;
  throw Error(Element::point, static_cast<std::size_t>(point),
              fmt::format("{}: point {} has the coordinate {}; finite ones up to 1e18 are possible: move it, or undo "
                          "this edit",
                          file, point, *beyond));
}

void require_same_count(const std::filesystem::path& from, std::size_t count, const std::filesystem::path& to,
                        std::size_t count_after) {
  if (count == 0) throw Error(Element::file, 0, from.string() + ": the sampling has no points; sample the scan again");
  if (count != count_after)
    throw Error(Element::file, 0,
                fmt::format("{}: has {} points, the sampling {} has {}; edit without adding or removing points",
                            to.string(), count_after, from.string(), count));
}

void fail_for_index(const std::string& file, std::size_t vertex, double index, std::size_t count) {
  throw Error(Element::point, vertex,
              fmt::format("{}: vertex {} has the index {}, which is repeated or not below {}; export it with the "
                          "indices of the sampling",
                          file, vertex, index, count));
}

SamplePairs::SamplePairs(std::filesystem::path from, std::filesystem::path to, const std::filesystem::path& folder)
    : from_(std::move(from)),
      to_(std::move(to)),
      before_(open_points(from_)->schema()),
      after_(open_points(to_)->schema()),
      count_(count_of(from_)) {
  require_same_count(from_, count_, to_, count_of(to_));
  if (channel_index(after_, "index") != none) join(folder);
}

void SamplePairs::join(const std::filesystem::path& folder) {
  joined_ = std::make_unique<TemporaryFile>(folder);
  const std::size_t index = channel_index(after_, "index"), width = after_.channels.size();
  RowWriter rows(*joined_, 3 + width);
  std::vector<bool> is_there(count_);
  const std::unique_ptr<PointReader> reader = open_points(to_, {.normals = false});
  for (Points points = reader->read(part); points.size() > 0; points = reader->read(part)) {
    require_within_floats(points.positions, points.first, to_.string());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::span<const double> channels = points.channels.subspan(width * i, width);
      const double sample = channels[index];
      if (!(sample >= 0 && sample < static_cast<double>(count_)) || is_there[static_cast<std::size_t>(sample)])
        fail_for_index(to_.string(), static_cast<std::size_t>(points.first) + i, sample, count_);
      is_there[static_cast<std::size_t>(sample)] = true;
      rows.write(static_cast<std::size_t>(sample), points.positions.subspan(3 * i, 3), channels);
    }
  }
  rows.flush(0);
}

std::unique_ptr<PointReader> SamplePairs::open_after() const {
  if (!joined_) return open_points(to_, {.normals = false});
  return std::make_unique<RowReader>(*joined_, to_.string(), after_, count_);
}

void SamplePairs::each(const std::function<void(const SamplePair& pair)>& take) const {
  const std::unique_ptr<PointReader> before = open_points(from_), after = open_after();
  std::vector<double> positions, channels;
  std::size_t count = 0;
  for (Points points = before->read(part); points.size() > 0; points = before->read(part)) {
    positions.clear();
    channels.clear();
    while (positions.size() < points.positions.size()) {
      const Points more = after->read(points.size() - positions.size() / 3);
      if (more.size() == 0) fail_for_change(to_);
      positions.insert(positions.end(), more.positions.begin(), more.positions.end());
      channels.insert(channels.end(), more.channels.begin(), more.channels.end());
    }
    require_within_floats(points.positions, points.first, from_.string());
    require_within_floats(positions, points.first, to_.string());
    take({points, positions, channels});
    count += points.size();
  }
  if (count != count_) fail_for_change(from_);
}

}  // namespace glark::stream
