// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The model as binary PLY, with its maps beside it. Texture coordinates are those of the vertices, as Blender reads them,
// and those of the faces' corners, as MeshLab and CloudCompare do.
#include <fmt/format.h>

#include <glark/maps.h>

#include <algorithm>
#include <bit>
#include <string>

#include "glark/clients/maps/output/file_set.h"
#include "glark/clients/maps/output/png.h"
#include "glark/clients/maps/output/triangle_strips.h"

namespace glark::maps {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie in memory");

// The names of the maps' files.
struct MapNames {
  std::string normals, colours, displacement;
};

template <class Value>
void add(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

bool has_origin(const Baked& model) { return model.origin != std::array<double, 3>{}; }
bool has_colours(const Baked& model) { return !model.colour_map.empty(); }

std::string header_of(const Baked& model, const MapNames& names, std::size_t strips) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by glark bake\n";
  if (has_colours(model)) text += "comment TextureFile " + names.colours + "\n";
  text += fmt::format("comment NormalFile {}\ncomment DisplacementFile {}\ncomment Displacement scale {} bias {}\n",
                      names.normals, names.displacement, model.scale, model.bias);
  text += fmt::format("element vertex {}\n", model.positions.size() / 3);
  for (const char* name : {"x", "y", "z"})
    text += fmt::format("property {} {}\n", has_origin(model) ? "double" : "float", name);
  for (const char* name : {"nx", "ny", "nz"}) text += fmt::format("property float {}\n", name);
  if (has_colours(model)) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += "property float s\nproperty float t\n";
  text += strips > 0 ? fmt::format("element tristrips {}\nproperty list int int vertex_indices\n", strips)
                     : fmt::format(
                           "element face {}\nproperty list uchar int vertex_indices\nproperty list uchar float "
                           "texcoord\n",
                           model.triangles.size() / 3);
  return text + "end_header\n";
}

// PLY's t grows upwards, and the first row of the maps is the upper one.
std::array<float, 2> texcoord_of(const Baked& model, std::uint32_t vertex) {
  return {model.texcoords[2 * std::size_t{vertex}], 1 - model.texcoords[2 * std::size_t{vertex} + 1]};
}

// The texel at a vertex.
std::array<std::uint8_t, 3> colour_of(const Baked& model, std::uint32_t vertex) {
  const auto texel = [](float at, unsigned size) {
    return std::min(static_cast<std::size_t>(std::max(at, 0.0F) * static_cast<float>(size)), std::size_t{size} - 1);
  };
  const std::size_t at = texel(model.texcoords[2 * std::size_t{vertex} + 1], model.height) * model.width +
                         texel(model.texcoords[2 * std::size_t{vertex}], model.width);
  return {model.colour_map[3 * at], model.colour_map[3 * at + 1], model.colour_map[3 * at + 2]};
}

void add_vertices(std::string& bytes, const Baked& model) {
  for (std::uint32_t v = 0; v < model.positions.size() / 3; ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float x = model.positions[3 * std::size_t{v} + k];
      if (has_origin(model))
        add(bytes, model.origin[k] + static_cast<double>(x));
      else
        add(bytes, x);
    }
    for (std::size_t k = 0; k < 3; ++k) add(bytes, model.normals[3 * std::size_t{v} + k]);
    if (has_colours(model)) add(bytes, colour_of(model, v));
    add(bytes, texcoord_of(model, v));
  }
}

void add_faces(std::string& bytes, const Baked& model) {
  for (std::size_t i = 0; i < model.triangles.size(); i += 3) {
    bytes += '\3';
    for (std::size_t k = 0; k < 3; ++k) add(bytes, model.triangles[i + k]);
    bytes += '\6';
    for (std::size_t k = 0; k < 3; ++k) add(bytes, texcoord_of(model, model.triangles[i + k]));
  }
}

void add_strips(std::string& bytes, const TriangleStrips& strips) {
  const std::uint32_t* vertex = strips.vertices.data();
  for (const std::uint32_t size : strips.sizes) {
    add(bytes, size);
    for (std::uint32_t k = 0; k < size; ++k) add(bytes, *vertex++);
  }
}

std::string ply_of(const Baked& model, const MapNames& names, bool as_strips) {
  const TriangleStrips strips = as_strips ? strips_of(model.triangles) : TriangleStrips{};
  std::string bytes = header_of(model, names, strips.sizes.size());
  add_vertices(bytes, model);
  if (as_strips)
    add_strips(bytes, strips);
  else
    add_faces(bytes, model);
  return bytes;
}

// A comment ends with its line.
void require_one_line(const std::filesystem::path& file) {
  if (file.filename().string().find_first_of("\r\n") != std::string::npos)
    throw Error(
        Element::file, 0,
        file.string() + ": the name has a line break, which a comment of a PLY file cannot have; give another name");
}

}  // namespace

void write_ply(const std::filesystem::path& file, const Baked& model, bool strips) {
  require_one_line(file);
  FileSet files;
  const auto add_map = [&](const char* ending, const auto& map) {
    std::filesystem::path beside = file;
    beside.replace_extension(ending);
    files.add(beside, png_of(std::span(map), model.width, model.height));
    return beside.filename().string();
  };
  MapNames names;
  names.normals = add_map(".normals.png", model.normal_map);
  if (has_colours(model)) names.colours = add_map(".colours.png", model.colour_map);
  names.displacement = add_map(".displacement.png", model.displacement_map);
  files.add(file, ply_of(model, names, strips));
  files.commit();
}

}  // namespace glark::maps
