// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <cstring>

#include "glark/clients/geometry/write/numbers.h"
#include "glark/clients/geometry/write/writers.h"

namespace glark::geometry {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie in memory");

bool has_origin(const Geometry& geometry) { return geometry.origin != std::array<double, 3>{}; }

bool has_faces(const Geometry& geometry) { return !geometry.triangles.empty() && geometry.strips.empty(); }

std::string header_of(const Geometry& geometry, PlyEncoding encoding) {
  const std::string type = has_origin(geometry) ? "double" : "float";
  std::string text = "ply\nformat ";
  text += encoding == PlyEncoding::text ? "ascii" : "binary_little_endian";
  text += fmt::format(" 1.0\ncomment written by glark\nelement vertex {}\n", geometry.point_count());
  for (const char* name : {"x", "y", "z"}) text += "property " + type + " " + name + "\n";
  if (!geometry.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!geometry.colours.empty())
    text += "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  if (!geometry.texture_coordinates.empty()) text += "property float s\nproperty float t\n";
  if (has_faces(geometry))
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", geometry.triangle_count());
  if (!geometry.strip_sizes.empty())
    text += fmt::format("element tristrips {}\nproperty list int int vertex_indices\n", geometry.strip_sizes.size());
  return text + "end_header\n";
}

void write_binary(OutputFile& file, const Geometry& geometry) {
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    if (has_origin(geometry)) {
      std::array<double, 3> position{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        position[axis] = geometry.origin[axis] + static_cast<double>(geometry.positions[3 * i + axis]);
      file.write_values(std::span<const double>(position));
    } else {
      file.write_values(std::span(geometry.positions).subspan(3 * i, 3));
    }
    if (!geometry.normals.empty()) file.write_values(std::span(geometry.normals).subspan(3 * i, 3));
    if (!geometry.colours.empty()) file.write_values(std::span(geometry.colours).subspan(4 * i, 4));
    if (!geometry.texture_coordinates.empty())
      file.write_values(std::span(geometry.texture_coordinates).subspan(2 * i, 2));
  }
  for (std::size_t i = 0; has_faces(geometry) && i < geometry.triangles.size(); i += 3) {
    file.write("\3");
    file.write_values(std::span(geometry.triangles).subspan(i, 3));
  }
  std::size_t begin = 0;
  for (const std::uint32_t size : geometry.strip_sizes) {
    file.write_values(std::span(&size, 1));
    file.write_values(std::span(geometry.strips).subspan(begin, size));
    begin += size;
  }
}

void write_text(OutputFile& file, const Geometry& geometry) {
  Line line;
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    line.clear();
    add_position(line, geometry, i);
    if (!geometry.normals.empty())
      for (std::size_t k = 0; k < 3; ++k) line.number(geometry.normals[3 * i + k]);
    if (!geometry.colours.empty())
      for (std::size_t k = 0; k < 4; ++k) line.number(static_cast<int>(geometry.colours[4 * i + k]));
    if (!geometry.texture_coordinates.empty())
      for (std::size_t k = 0; k < 2; ++k) line.number(geometry.texture_coordinates[2 * i + k]);
    file.write(line.end());
  }
  for (std::size_t i = 0; has_faces(geometry) && i < geometry.triangles.size(); i += 3) {
    line.clear();
    line.add("3");
    for (std::size_t k = 0; k < 3; ++k) line.number(geometry.triangles[i + k]);
    file.write(line.end());
  }
  std::size_t next = 0;
  for (const std::uint32_t size : geometry.strip_sizes) {
    line.clear();
    line.number(size);
    for (std::uint32_t k = 0; k < size; ++k) line.number(geometry.strips[next++]);
    file.write(line.end());
  }
}

}  // namespace

void write_ply(OutputFile& file, const Geometry& geometry, PlyEncoding encoding) {
  file.write(header_of(geometry, encoding));
  if (encoding == PlyEncoding::text)
    write_text(file, geometry);
  else
    write_binary(file, geometry);
}

}  // namespace glark::geometry
