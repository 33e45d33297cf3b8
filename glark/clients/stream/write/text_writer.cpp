// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "glark/clients/geometry/write/numbers.h"
#include "glark/clients/stream/format/numbers.h"
#include "glark/clients/stream/write/writers.h"

namespace glark::stream {
namespace {

class TextWriter final : public PointWriter {
 public:
  TextWriter(const Creation& creation, std::string format)
      : given_(creation.schema), schema_(creation.schema), format_(std::move(format)), file_(creation) {
    if (format_ != ".ply") choose_columns();
    if (format_ == ".ply")
      for (std::size_t k = 0; k < given_.channels.size(); ++k) columns_.push_back(k);
    file_.add(header(file_.expected()));
  }

  const Schema& schema() const override { return schema_; }

  void write(const Points& points) override {
    const std::size_t width = given_.channels.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      line_.clear();
      for (std::size_t k = 0; k < 3; ++k) number(points.positions[3 * i + k], given_.position);
      const auto add_normal = [&] {
        for (std::size_t k = 0; k < 3 && schema_.normals; ++k) line_.number(points.normals[3 * i + k]);
      };
      if (format_ == ".ply") add_normal();
      if (format_ == ".pts" && !has_intensity_) line_.add("0");
      for (const std::size_t column : columns_)
        number(points.channels[width * i + column], given_.channels[column].type);
      if (format_ != ".ply") add_normal();
      file_.add(line_.end());
    }
    file_.count(points.size());
  }

  void finish() override { file_.finish(header(file_.points())); }

 private:
  // XYZ and PTS have fixed columns: an intensity (PTS), and a colour.
  void choose_columns() {
    const std::size_t intensity = channel_index(given_, "intensity");
    has_intensity_ = format_ == ".pts" && intensity != none;
    if (has_intensity_) columns_.push_back(intensity);
    std::array<std::size_t, 3> colour{};
    constexpr std::array names{"red", "green", "blue"};
    for (std::size_t k = 0; k < 3; ++k) colour[k] = channel_index(given_, names[k]);
    if (std::find(colour.begin(), colour.end(), none) == colour.end())
      columns_.insert(columns_.end(), colour.begin(), colour.end());
    schema_.channels.clear();
    for (const std::size_t column : columns_) schema_.channels.push_back(given_.channels[column]);
  }

  std::string header(std::uint64_t count) const {
    if (format_ == ".ply") return ply_header(given_, count, true);
    return format_ == ".pts" ? fmt::format("{:<20}\n", count) : "";
  }

  void number(double value, Number type) {
    if (type == Number::float64)
      line_.number(value);
    else if (type == Number::float32)
      line_.number(static_cast<float>(value));
    else
      line_.number(static_cast<long long>(value));
  }

  Schema given_, schema_;
  std::string format_;
  WriterFile file_;
  std::vector<std::size_t> columns_;
  bool has_intensity_ = false;
  geometry::Line line_;
};

}  // namespace

std::string ply_header(const Schema& schema, std::uint64_t count, bool text) {
  const std::string digits = std::to_string(count);
  std::string header = "ply\nformat ";
  header += text ? "ascii" : "binary_little_endian";
  header += " 1.0\ncomment written by glark" + std::string(20 - digits.size(), ' ') + "\n";
  header += "element vertex " + digits + "\n";
  for (const char* name : {"x", "y", "z"}) header += fmt::format("property {} {}\n", name_of(schema.position), name);
  if (schema.normals) header += "property float nx\nproperty float ny\nproperty float nz\n";
  for (const Channel& channel : schema.channels)
    header += fmt::format("property {} {}\n", name_of(channel.type), channel.name);
  return header + "end_header\n";
}

std::unique_ptr<PointWriter> text_writer(const Creation& creation, const std::string& format) {
  return std::make_unique<TextWriter>(creation, format);
}

}  // namespace glark::stream
