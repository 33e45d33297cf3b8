// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <bit>

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/stream/format/layouts.h"

namespace glark::stream {
namespace {

namespace ply = geometry::ply;

Number number_of(ply::Type type) {  // both enumerations have the same order
  static_assert(static_cast<int>(ply::Type::float64) == static_cast<int>(Number::float64));
  return static_cast<Number>(type);
}

// Returns the name that glark uses for the property.
std::string plain_name(const std::string& name) {
  constexpr std::array<std::array<const char*, 2>, 10> others{{{"normal_x", "nx"},
                                                               {"normal_y", "ny"},
                                                               {"normal_z", "nz"},
                                                               {"diffuse_red", "red"},
                                                               {"diffuse_green", "green"},
                                                               {"diffuse_blue", "blue"},
                                                               {"diffuse_alpha", "alpha"},
                                                               {"r", "red"},
                                                               {"g", "green"},
                                                               {"b", "blue"}}};
  for (const auto& [other, plain] : others)
    if (name == other) return plain;
  return name;
}

// The properties of the element vertex: fields at their places, which are the properties' numbers for text.
class Properties {
 public:
  Properties(const ply::Element& vertex, const std::string& file) {
    std::uint32_t offset = 0;
    for (const ply::Property& property : vertex.properties) {
      if (property.count_type)
        throw Error(Element::file, 0,
                    file + ": element vertex: its property " + property.name +
                        " is a list, which cannot be streamed; export the file without it");
      add(plain_name(property.name), {.offset = offset, .type = number_of(property.type)});
      offset += static_cast<std::uint32_t>(size_of(number_of(property.type)));
    }
    layout_.record_size = layout_.point_size = offset;
    constexpr std::array names{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (layout_.position[axis].offset == no_field)
        throw Error(Element::file, 0,
                    file + ": element vertex: there is no property " + names[axis] +
                        "; points need x, y and z, export the file with positions");
    Schema& schema = layout_.schema;
    schema.normals =
        layout_.has_normals() && layout_.normal[1].offset != no_field && layout_.normal[2].offset != no_field;
    if (!schema.normals) layout_.normal = {};
    for (const Field& field : layout_.position)
      if (field.type != Number::float32) schema.position = Number::float64;
  }
  const Layout& layout() const { return layout_; }

 private:
  void add(const std::string& name, const Field& field) {
    constexpr std::array positions{"x", "y", "z"}, normals{"nx", "ny", "nz"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (name == positions[axis]) layout_.position[axis] = field;
      if (name == normals[axis]) layout_.normal[axis] = field;
      if (name == positions[axis] || name == normals[axis]) return;
    }
    if (channel_index(layout_.schema, name) != none) return;
    layout_.schema.channels.push_back({name, field.type});
    layout_.channels.push_back(field);
  }

  Layout layout_;
};

}  // namespace

Layout vertex_layout(const ply::Element& vertex, const std::string& file) { return Properties(vertex, file).layout(); }

std::optional<Layout> ply_layout(const SourceFile& file) {
  geometry::Input input = geometry::open_input(file.name());
  const ply::Header header = ply::read_header(input);
  if (header.encoding == ply::Encoding::text || !input.remaining()) return std::nullopt;
  std::uint64_t begin = file.size() - *input.remaining();
  for (const ply::Element& element : header.elements) {
    if (element.name == "vertex") {
      Layout layout = vertex_layout(element, file.name());
      layout.begin = begin;
      layout.records = element.count;
      layout.swapped = (header.encoding == ply::Encoding::big_endian) != (std::endian::native == std::endian::big);
      return layout;
    }
    if (element.has_lists())
      throw Error(Element::file, 0,
                  file.name() + ": element " + element.name +
                      " stands before the points and has lists, so that the points cannot be found; export the file "
                      "with the points first");
    begin += element.count * element.least_size(header.encoding);
  }
  throw Error(Element::file, 0, file.name() + ": PLY header: there is no element vertex; export the file with points");
}

}  // namespace glark::stream
