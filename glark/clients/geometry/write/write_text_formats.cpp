// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Writes OBJ, XYZ, PTS and STL.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "glark/clients/common/vector.h"
#include "glark/clients/geometry/write/numbers.h"
#include "glark/clients/geometry/write/writers.h"

namespace glark::geometry {
namespace {

void write_rows(OutputFile& file, const Geometry& geometry, bool with_intensity) {
  Line line;
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    line.clear();
    add_position(line, geometry, i);
    if (with_intensity) line.number(0);
    if (!geometry.colours.empty())
      for (std::size_t k = 0; k < 3; ++k) line.number(static_cast<int>(geometry.colours[4 * i + k]));
    if (!geometry.normals.empty())
      for (std::size_t k = 0; k < 3; ++k) line.number(geometry.normals[3 * i + k]);
    file.write(line.end());
  }
}

// A corner of a face: "7", "7/7", "7//7" or "7/7/7". Indices count from 1.
std::string corner(const Geometry& geometry, std::uint32_t index) {
  const std::string number = std::to_string(std::uint64_t{index} + 1);
  std::string text = number;
  if (!geometry.texture_coordinates.empty()) text += "/" + number;
  if (!geometry.normals.empty()) text += (geometry.texture_coordinates.empty() ? "//" : "/") + number;
  return text;
}

using Vector = common::Vector3f;

// Returns the unit normal, or zero for a triangle without area.
Vector face_normal(Vector a, Vector b, Vector c) {
  const Vector normal = cross(b - a, c - a);
  const float size = length(normal);
  return size > 0 ? Vector{normal.x / size, normal.y / size, normal.z / size} : Vector{};
}

}  // namespace

void write_xyz(OutputFile& file, const Geometry& geometry) { write_rows(file, geometry, false); }

void write_pts(OutputFile& file, const Geometry& geometry) {
  file.write(fmt::format("{}\n", geometry.point_count()));
  write_rows(file, geometry, !geometry.colours.empty());
}

void write_obj(OutputFile& file, const Geometry& geometry) {
  Line line;
  file.write("# written by glark\n");
  for (std::size_t i = 0; i < geometry.point_count(); ++i) {
    line.clear();
    line.add("v");
    add_position(line, geometry, i);
    if (!geometry.colours.empty())
      for (std::size_t k = 0; k < 3; ++k) line.number(static_cast<float>(geometry.colours[4 * i + k]) / 255.0F);
    file.write(line.end());
  }
  for (std::size_t i = 0; i < geometry.texture_coordinates.size(); i += 2) {
    line.clear();
    file.write(
        line.add("vt").number(geometry.texture_coordinates[i]).number(geometry.texture_coordinates[i + 1]).end());
  }
  for (std::size_t i = 0; i < geometry.normals.size(); i += 3) {
    line.clear();
    line.add("vn");
    for (std::size_t k = 0; k < 3; ++k) line.number(geometry.normals[i + k]);
    file.write(line.end());
  }
  for (std::size_t i = 0; i < geometry.triangles.size(); i += 3) {
    line.clear();
    line.add("f");
    for (std::size_t k = 0; k < 3; ++k) line.add(corner(geometry, geometry.triangles[i + k]));
    file.write(line.end());
  }
}

void write_stl(OutputFile& file, const Geometry& geometry, const std::string& name) {
  if (geometry.triangles.empty())
    throw Error(name +
                ": STL holds triangles and there are only points; write PLY or XYZ, or reconstruct a surface first");
  std::string header = "written by glark";
  header.resize(80, ' ');
  file.write(header);
  const auto count = static_cast<std::uint32_t>(geometry.triangle_count());
  file.write_values(std::span(&count, 1));
  for (std::size_t i = 0; i < geometry.triangles.size(); i += 3) {
    std::array<Vector, 4> record{};  // normal and corners
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis)
        record[k + 1][axis] = static_cast<float>(
            geometry.origin[axis] +
            static_cast<double>(geometry.positions[3 * std::size_t{geometry.triangles[i + k]} + axis]));
    record[0] = face_normal(record[1], record[2], record[3]);
    file.write_values(std::span<const Vector>(record));
    file.write(std::string_view("\0\0", 2));
  }
}

}  // namespace glark::geometry
