// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Writers of records of one size: binary PLY, LAS and triples of floats.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/stream/format/las_header.h"
#include "glark/clients/stream/format/layout.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

class RecordWriter : public PointWriter {
 public:
  const Schema& schema() const final { return layout_.schema; }

  void write(const Points& points) final {
    if (points.size() == 0) return;
    begin(points);
    records_.assign(points.size() * layout_.record_size, '\0');
    encode(layout_, file_.name(), file_.points(), points.positions,
           layout_.has_normals() ? points.normals : std::span<const float>{}, records_);
    const Column column{layout_.record_size, points.size(), layout_.swapped};
    const std::size_t width = points.channels.size() / points.size();
    for (std::size_t k = 0; k < layout_.channels.size(); ++k) {
      const std::size_t bad =
          write_column(layout_.channels[k], column, records_.data(), points.channels.data() + from_[k], width);
      if (bad < points.size())
        throw Error(Element::point, file_.points() + bad,
                    fmt::format("{}: the {} of point {} is {}, which a {} cannot hold; change the type of the channel",
                                file_.name(), layout_.schema.channels[k].name, file_.points() + bad,
                                points.channels[bad * width + from_[k]], name_of(layout_.channels[k].type)));
    }
    note(points);
    file_.add({records_.data(), records_.size()});
    file_.count(points.size());
  }

 protected:
  explicit RecordWriter(const Creation& creation) : given_(creation.schema), file_(creation) {}

  // Called before the points are encoded. The first call writes the header.
  virtual void begin(const Points& points) = 0;
  virtual void note(const Points&) {}

  // Adds the channels of the layout that the given schema has, with their types there.
  void choose_channels(const Layout& full) {
    for (std::size_t k = 0; k < full.channels.size(); ++k) {
      const std::size_t from = channel_index(given_, full.schema.channels[k].name);
      if (from == none) continue;
      layout_.channels.push_back(full.channels[k]);
      layout_.schema.channels.push_back(full.schema.channels[k]);
      from_.push_back(from);
    }
  }

  Schema given_;
  WriterFile file_;
  Layout layout_;
  std::vector<std::size_t> from_;  // for each channel of the layout, its index in what is given
  std::vector<char> records_;
};

class PlyWriter final : public RecordWriter {
 public:
  explicit PlyWriter(const Creation& creation) : RecordWriter(creation) {
    std::uint32_t offset = 0;
    const auto next = [&](Number type) {
      const Field field{.offset = offset, .type = type};
      offset += static_cast<std::uint32_t>(size_of(type));
      return field;
    };
    for (Field& field : layout_.position) field = next(given_.position);
    if (given_.normals)
      for (Field& field : layout_.normal) field = next(Number::float32);
    for (std::size_t k = 0; k < given_.channels.size(); ++k) {
      layout_.channels.push_back(next(given_.channels[k].type));
      from_.push_back(k);
    }
    layout_.record_size = layout_.point_size = offset;
    layout_.schema = given_;
  }
  void finish() override {
    if (file_.points() == 0) file_.add(ply_header(given_, file_.expected(), false));
    file_.finish(ply_header(given_, file_.points(), false));
  }

 private:
  void begin(const Points&) override {
    if (file_.points() == 0) file_.add(ply_header(given_, file_.expected(), false));
  }
};

class RawWriter final : public RecordWriter {
 public:
  explicit RawWriter(const Creation& creation) : RecordWriter(creation) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) layout_.position[axis].offset = 4 * axis;
    layout_.record_size = layout_.point_size = 12;
  }
  void finish() override { file_.finish({}); }

 private:
  void begin(const Points&) override {}
};

class LasWriter final : public RecordWriter {
 public:
  explicit LasWriter(const Creation& creation) : RecordWriter(creation), step_(creation.options.step) {
    header_.file = creation.file.string();
    header_.point_format = las_format_for(given_);
    header_.record_size = las_layout_size();
    header_.least.fill(std::numeric_limits<double>::infinity());
    header_.greatest.fill(-std::numeric_limits<double>::infinity());
    set_layout();
  }
  void finish() override {
    header_.points = file_.points();
    if (file_.points() == 0) header_.least = header_.greatest = {};
    std::vector<char> bytes = las_header_bytes(header_);
    patch_las_header(header_, bytes);
    if (file_.points() == 0) file_.add({bytes.data(), bytes.size()});
    file_.finish({bytes.data(), bytes.size()});
  }

 private:
  std::uint16_t las_layout_size() const {
    constexpr std::array<std::uint16_t, 8> sizes{20, 28, 26, 34, 57, 63, 30, 36};
    return sizes[header_.point_format];
  }

  void set_layout() {
    const Layout full = las_layout(header_);
    layout_ = full;
    layout_.channels.clear();
    layout_.schema.channels.clear();
    from_.clear();
    choose_channels(full);
    // Colours of LAS have 16 bits.
    for (std::size_t k = 0; k < from_.size(); ++k) {
      const bool is_byte = given_.channels[from_[k]].type == Number::uint8;
      const std::string& name = given_.channels[from_[k]].name;
      if (is_byte && (name == "red" || name == "green" || name == "blue")) layout_.channels[k].scale = 1.0 / 257;
    }
  }

  // Chooses the offset and the step by the first points: at most a millionth of their extent, so that
  // later points may lie a hundred times as far.
  void begin(const Points& points) override {
    if (file_.points() > 0) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double most = 1e-9;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double coordinate = points.positions[3 * i + axis];
        if (i == 0) header_.offset[axis] = std::floor(coordinate);
        most = std::max(most, std::abs(coordinate - header_.offset[axis]));
      }
      header_.scale[axis] = step_ > 0 ? step_ : std::pow(10.0, std::floor(std::log10(most * 0x1p-20)));
    }
    set_layout();
    std::vector<char> bytes = las_header_bytes(header_);
    header_.points = file_.expected();
    patch_las_header(header_, bytes);
    file_.add({bytes.data(), bytes.size()});
  }

  void note(const Points& points) override {
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      header_.least[i % 3] = std::min(header_.least[i % 3], points.positions[i]);
      header_.greatest[i % 3] = std::max(header_.greatest[i % 3], points.positions[i]);
    }
  }

  double step_;
  LasHeader header_;
};

}  // namespace

std::unique_ptr<PointWriter> ply_writer(const Creation& creation) { return std::make_unique<PlyWriter>(creation); }
std::unique_ptr<PointWriter> las_writer(const Creation& creation) { return std::make_unique<LasWriter>(creation); }
std::unique_ptr<PointWriter> raw_writer(const Creation& creation) { return std::make_unique<RawWriter>(creation); }

}  // namespace glark::stream
