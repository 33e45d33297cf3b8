// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/read/ply_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "glark/clients/geometry/parse/ply_header.h"
#include "glark/clients/geometry/parse/ply_values.h"
#include "glark/clients/geometry/read/points/point_builder.h"
#include "glark/clients/geometry/read/points/point_counter.h"

namespace glark::geometry {
namespace {

using ply::Element;
using ply::Property;
using ply::Type;

// The meaning of a vertex's property.
enum Slot {
  slot_x,
  slot_y,
  slot_z,
  slot_nx,
  slot_ny,
  slot_nz,
  slot_red,
  slot_green,
  slot_blue,
  slot_alpha,
  slot_s,
  slot_t,
  slot_count
};

std::optional<Slot> slot_of(std::string_view name) {
  struct Name {
    std::string_view name;
    Slot slot;
  };
  constexpr std::array names{Name{"x", slot_x},
                             Name{"y", slot_y},
                             Name{"z", slot_z},
                             Name{"nx", slot_nx},
                             Name{"ny", slot_ny},
                             Name{"nz", slot_nz},
                             Name{"normal_x", slot_nx},
                             Name{"normal_y", slot_ny},
                             Name{"normal_z", slot_nz},
                             Name{"red", slot_red},
                             Name{"green", slot_green},
                             Name{"blue", slot_blue},
                             Name{"alpha", slot_alpha},
                             Name{"diffuse_red", slot_red},
                             Name{"diffuse_green", slot_green},
                             Name{"diffuse_blue", slot_blue},
                             Name{"diffuse_alpha", slot_alpha},
                             Name{"r", slot_red},
                             Name{"g", slot_green},
                             Name{"b", slot_blue},
                             Name{"s", slot_s},
                             Name{"t", slot_t},
                             Name{"u", slot_s},
                             Name{"v", slot_t},
                             Name{"texture_u", slot_s},
                             Name{"texture_v", slot_t}};
  const auto* found = std::find_if(names.begin(), names.end(), [&](const Name& known) { return known.name == name; });
  return found == names.end() ? std::nullopt : std::optional(found->slot);
}

class Vertices {
 public:
  Vertices(const Input& input, const Element& element) : values_(element.properties.size()) {
    column_.fill(none);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (property.count_type)
        throw Error(input.name() + ": element vertex: its property " + property.name +
                    " is a list, which glark does not read; export the file without it");
      const std::optional<Slot> slot = slot_of(property.name);
      if (slot && column_[*slot] == none) {
        column_[*slot] = static_cast<int>(i);
        type_[*slot] = property.type;
      } else if (!slot) {
        unread_ += (unread_.empty() ? "" : ", ") + property.name;
      }
    }
    constexpr std::array names{"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
      if (column_[axis] == none)
        throw Error(input.name() + ": element vertex: there is no property " + names[axis] +
                    "; points need x, y and z, export the file with positions");
    attributes_.normals = has({slot_nx, slot_ny, slot_nz});
    attributes_.colours = has({slot_red, slot_green, slot_blue});
    attributes_.texture_coordinates = has({slot_s, slot_t});
    // In files with other types, each channel becomes a byte according to its own type.
    if (is_float(slot_red) && is_float(slot_green) && is_float(slot_blue) &&
        (column_[slot_alpha] == none || is_float(slot_alpha)))
      colour_range_ = ColourRange::by_greatest;
  }

  const Attributes& attributes() const { return attributes_; }
  ColourRange colour_range() const { return colour_range_; }
  const std::string& unread() const { return unread_; }
  std::span<double> values() { return values_; }

  void add_to(PointSink& sink) const {
    Point point;
    for (int axis = 0; axis < 3; ++axis) point.position[axis] = value(static_cast<Slot>(axis));
    if (attributes_.normals)
      for (int axis = 0; axis < 3; ++axis)
        point.normal[axis] = static_cast<float>(value(static_cast<Slot>(slot_nx + axis)));
    if (attributes_.colours) {
      for (int channel = 0; channel < 3; ++channel)
        point.colour[channel] = colour(static_cast<Slot>(slot_red + channel));
      if (column_[slot_alpha] != none) point.colour[3] = std::max(0.0F, colour(slot_alpha));
    }
    if (attributes_.texture_coordinates)
      point.texture_coordinate = {static_cast<float>(value(slot_s)), static_cast<float>(value(slot_t))};
    sink.add_point(point,
                   type_[slot_x] == Type::float64 || type_[slot_y] == Type::float64 || type_[slot_z] == Type::float64);
  }

 private:
  static constexpr int none = -1;

  bool has(std::initializer_list<Slot> slots) const {
    return std::all_of(slots.begin(), slots.end(), [&](Slot slot) { return column_[slot] != none; });
  }

  bool is_float(Slot slot) const { return type_[slot] == Type::float32 || type_[slot] == Type::float64; }

  double value(Slot slot) const { return values_[static_cast<std::size_t>(column_[slot])]; }

  float colour(Slot slot) const {
    const auto channel = static_cast<float>(value(slot));
    if (type_[slot] == Type::uint16) return channel / 257;
    return is_float(slot) && colour_range_ == ColourRange::byte ? 255 * channel : channel;
  }

  std::array<int, slot_count> column_{};
  std::array<Type, slot_count> type_{};
  std::vector<double> values_;
  Attributes attributes_;
  ColourRange colour_range_ = ColourRange::byte;
  std::string unread_;
};

bool is_corner_list(const Property& property) {
  return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class Body {
 public:
  Body(Input& input, const ply::Header& header, const ReadOptions& options)
      : input_(input), header_(header), options_(options), values_(input, header.encoding) {}

  // Sink: PointBuilder or PointCounter.
  template <class Sink>
  typename Sink::Result read() {
    const auto vertex = std::find_if(header_.elements.begin(), header_.elements.end(),
                                     [](const Element& element) { return element.name == "vertex"; });
    if (vertex == header_.elements.end())
      throw Error(input_.name() + ": PLY header: there is no element vertex; export the file with points");
    Vertices vertices(input_, *vertex);
    Sink sink(input_.name(), "vertex", vertices.attributes(), options_, vertices.colour_range());
    std::uint64_t faces = 0;
    for (const Element& element : header_.elements) faces += element.name == "face" ? element.count : 0;
    sink.expect(vertex->count, faces);
    if (!vertices.unread().empty()) sink.warn("properties of vertex that are not kept: " + vertices.unread());
    for (const Element& element : header_.elements) {
      if (&element == &*vertex)
        read_vertices(vertices, element, sink);
      else if (element.name == "face" || element.name == "tristrips")
        read_faces(element, sink);
      else
        skip(element, sink);
    }
    if (header_.encoding == ply::Encoding::text ? !input_.word().empty() : !input_.take(1).empty())
      sink.warn("something follows the last element; the header may announce too little");
    return sink.finish();
  }

 private:
  void read_vertices(Vertices& vertices, const Element& element, PointSink& sink) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.at(element, i);
      values_.record(vertices.values());
      vertices.add_to(sink);
    }
  }

  void read_faces(const Element& element, PointSink& sink) {
    if (std::none_of(element.properties.begin(), element.properties.end(), is_corner_list))
      throw Error(input_.name() + ": element " + element.name +
                  ": there is no list vertex_indices; export the faces again");
    std::string unread;
    for (const Property& property : element.properties)
      if (!is_corner_list(property)) unread += (unread.empty() ? "" : ", ") + property.name;
    if (!unread.empty()) sink.warn("properties of " + element.name + " that are not kept: " + unread);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values_.at(element, i);
      for (const Property& property : element.properties) {
        if (!property.count_type) {
          values_.number(property.type);
          continue;
        }
        values_.list(property, list_);
        if (!is_corner_list(property)) continue;
        corners_.clear();
        for (const double corner : list_) corners_.push_back(corner_of(corner));
        if (element.name == "face")
          sink.add_polygon(corners_);
        else
          add_strips(sink);
      }
    }
  }

  std::int64_t corner_of(double value) const {
    if (!(value >= -1 && value <= 4294967295.0) || value != std::floor(value))
      values_.fail("a corner is not an index; the file is damaged, get it again");
    return static_cast<std::int64_t>(value);
  }

  // Adds triangle strips. Each strip ends with -1, as in the Stanford models. Degenerate triangles join the parts of a
  // strip.
  void add_strips(PointSink& sink) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i] < 0) begin = i + 1;
      if (i < begin + 2) continue;
      if (corners_[i] == corners_[i - 1] || corners_[i] == corners_[i - 2] || corners_[i - 1] == corners_[i - 2])
        continue;
      const bool turned = (i - begin) % 2 == 1;
      sink.add_polygon(std::array{corners_[i - 2], corners_[turned ? i : i - 1], corners_[turned ? i - 1 : i]});
    }
  }

  void skip(const Element& element, PointSink& sink) {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      values_.at(element, i);
      for (const Property& property : element.properties)
        if (property.count_type)
          values_.list(property, list_);
        else
          values_.number(property.type);
    }
    if (element.count > 0) sink.warn("element " + element.name + " is not kept");
  }

  Input& input_;
  const ply::Header& header_;
  const ReadOptions& options_;
  ply::Values values_;
  std::vector<double> list_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

Reading read_ply(Input& input, const ReadOptions& options) {
  const ply::Header header = ply::read_header(input);
  return Body(input, header, options).read<PointBuilder>();
}

Summary summarise_ply(Input& input, const ReadOptions& options) {
  const ply::Header header = ply::read_header(input);
  return Body(input, header, options).read<PointCounter>();
}

}  // namespace glark::geometry
