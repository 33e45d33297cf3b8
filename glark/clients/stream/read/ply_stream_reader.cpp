// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "glark/clients/geometry/parse/ply_values.h"
#include "glark/clients/stream/format/layouts.h"
#include "glark/clients/stream/read/stream_reader.h"

namespace glark::stream {
namespace {

namespace ply = geometry::ply;

class PlyStreamReader final : public StreamReader {
 public:
  PlyStreamReader(geometry::Input input, const ply::Header& header, const ReadOptions& options)
      : StreamReader(std::move(input), "vertex", options), header_(header), values_(input_, header_.encoding) {
    const auto vertex = std::find_if(header_.elements.begin(), header_.elements.end(),
                                     [](const ply::Element& element) { return element.name == "vertex"; });
    if (vertex == header_.elements.end())
      throw Error(Element::file, 0, name() + ": PLY header: there is no element vertex; export the file with points");
    layout_ = vertex_layout(*vertex, name());
    schema_ = layout_.schema;
    schema_.normals = schema_.normals && options_.normals;
    all_channels_ = schema_.channels.size();
    if (!options_.channels) schema_.channels.clear();
    vertex_ = &*vertex;
    row_.resize(vertex_->properties.size());
    // A field's offset in bytes tells the number of its property.
    places_.resize(layout_.record_size + 1);
    std::size_t offset = 0;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      places_[offset] = i;
      offset += ply::size_of(vertex_->properties[i].type);
    }
  }

  std::optional<std::uint64_t> count() const override { return vertex_->count; }

  Points read(std::size_t most) override {
    return reading([&] {
      if (next_ == 0) skip_to_vertices();
      clear();
      channels_.resize(all_channels_);
      const std::uint64_t end = std::min<std::uint64_t>(vertex_->count, next_ + std::max<std::size_t>(1, most));
      for (std::uint64_t i = next_; i < end; ++i) add_vertex(i);
      return finish_block();
    });
  }

 private:
  double value(const Field& field) const { return row_[places_[field.offset]]; }

  void add_vertex(std::uint64_t index) {
    values_.at(*vertex_, index);
    values_.record(row_);
    std::array<double, 3> position{};
    std::array<float, 3> normal{};
    for (std::size_t k = 0; k < 3; ++k) {
      position[k] = value(layout_.position[k]);
      if (layout_.has_normals()) normal[k] = static_cast<float>(value(layout_.normal[k]));
    }
    for (std::size_t k = 0; k < all_channels_; ++k) channels_[k] = value(layout_.channels[k]);
    add(position.data(), normal.data(), channels_);
  }

  void skip_to_vertices() {
    std::vector<double> list;
    for (const ply::Element* element = header_.elements.data(); element != vertex_; ++element)
      for (std::uint64_t i = 0; i < element->count; ++i) {
        values_.at(*element, i);
        for (const ply::Property& property : element->properties)
          property.count_type ? values_.list(property, list) : static_cast<void>(values_.number(property.type));
      }
  }

  const ply::Header header_;
  ply::Values values_;
  const ply::Element* vertex_ = nullptr;
  Layout layout_;
  std::size_t all_channels_ = 0;
  std::vector<std::size_t> places_;
  std::vector<double> row_, channels_;
};

}  // namespace

std::unique_ptr<PointReader> ply_stream_reader(geometry::Input input, const ply::Header& header,
                                               const ReadOptions& options) {
  return std::make_unique<PlyStreamReader>(std::move(input), header, options);
}

}  // namespace glark::stream
