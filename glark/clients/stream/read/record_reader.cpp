// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "glark/clients/stream/read/readers.h"

namespace glark::stream {
namespace {

class RecordReader final : public PointReader {
 public:
  RecordReader(SourceFile file, Layout layout, const ReadOptions& options)
      : file_(std::move(file)), layout_(std::move(layout)), options_(options), schema_(layout_.schema) {
    schema_.normals = schema_.normals && options_.normals;
    if (!options_.channels) schema_.channels.clear();
  }

  const std::string& name() const override { return file_.name(); }
  const Schema& schema() const override { return schema_; }
  std::optional<std::uint64_t> count() const override { return layout_.points(); }

  // A triangle of STL has three points. Those that were not asked for are left out, and read again by the next call.
  Points read(std::size_t most) override {
    const std::uint64_t each = layout_.points_per_record;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(layout_.points() - next_, most));
    const std::uint64_t first = next_ / each;
    const auto records = static_cast<std::size_t>((next_ + count + each - 1) / each - first);
    bytes_.resize(records * layout_.record_size);
    file_.read(layout_.begin + first * layout_.record_size, bytes_);
    decode(layout_, bytes_.data(), records, options_, arrays_);
    const Points points = part_of(arrays_.points(next_), static_cast<std::size_t>(next_ % each), count);
    next_ += count;
    if (!options_.keep_invalid) require_finite(points, file_.name(), layout_.element);
    return points;
  }

  bool can_seek() const override { return true; }

  void seek(std::uint64_t point) override {
    if (point > layout_.points())
      throw Error(Element::point, point,
                  fmt::format("{}: point {} is sought, the file has {}", file_.name(), point, layout_.points()));
    next_ = point;
  }

 private:
  // Some points of those that were decoded.
  static Points part_of(const Points& all, std::size_t begin, std::size_t count) {
    if (count == all.size()) return all;
    Points part = all;
    const std::size_t width = all.channels.size() / all.size();
    part.positions = all.positions.subspan(3 * begin, 3 * count);
    if (!all.normals.empty()) part.normals = all.normals.subspan(3 * begin, 3 * count);
    part.channels = all.channels.subspan(width * begin, width * count);
    return part;
  }

  SourceFile file_;
  Layout layout_;
  ReadOptions options_;
  Schema schema_;
  std::uint64_t next_ = 0;  // a point
  std::vector<char> bytes_;
  PointArrays arrays_;
};

}  // namespace

std::unique_ptr<PointReader> record_reader(SourceFile file, Layout layout, const ReadOptions& options) {
  return std::make_unique<RecordReader>(std::move(file), std::move(layout), options);
}

}  // namespace glark::stream
