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

  Points read(std::size_t most) override {
    const std::uint64_t each = layout_.points_per_record;
    const std::uint64_t left = layout_.records - next_;
    const auto records =
        static_cast<std::size_t>(std::min<std::uint64_t>(left, std::max<std::uint64_t>(1, most / each)));
    bytes_.resize(records * layout_.record_size);
    file_.read(layout_.begin + next_ * layout_.record_size, bytes_);
    decode(layout_, bytes_.data(), records, options_, arrays_);
    Points points = arrays_.points(next_ * each);
    next_ += records;
    const std::uint64_t skipped = std::exchange(skipped_, 0);
    if (skipped > 0) {
      points.first += skipped;
      points.positions = points.positions.subspan(3 * skipped);
      if (!points.normals.empty()) points.normals = points.normals.subspan(3 * skipped);
      points.channels = points.channels.subspan(schema_.channels.size() * skipped);
    }
    if (!options_.keep_invalid) require_finite(points, file_.name(), layout_.element);
    return points;
  }

  bool can_seek() const override { return true; }

  void seek(std::uint64_t point) override {
    if (point > layout_.points())
      throw Error(Element::point, point,
                  fmt::format("{}: point {} is sought, the file has {}", file_.name(), point, layout_.points()));
    next_ = point / layout_.points_per_record;
    skipped_ = point % layout_.points_per_record;
  }

 private:
  SourceFile file_;
  Layout layout_;
  ReadOptions options_;
  Schema schema_;
  std::uint64_t next_ = 0;     // a record
  std::uint64_t skipped_ = 0;  // points of that record, after seek()
  std::vector<char> bytes_;
  PointArrays arrays_;
};

}  // namespace

std::unique_ptr<PointReader> record_reader(SourceFile file, Layout layout, const ReadOptions& options) {
  return std::make_unique<RecordReader>(std::move(file), std::move(layout), options);
}

}  // namespace glark::stream
