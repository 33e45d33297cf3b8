// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/format/layouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>

#include "glark/clients/stream/format/las_header.h"

namespace glark::stream {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

// Three floats at `offset`.
std::array<Field, 3> floats_at(std::uint32_t offset) {
  return {Field{.offset = offset}, Field{.offset = offset + 4}, Field{.offset = offset + 8}};
}

}  // namespace

Layout stl_layout(const SourceFile& file) {
  constexpr std::uint32_t header_size = 84, triangle_size = 50;
  std::array<char, header_size> header{};
  if (file.size() < header.size())
    throw Error(
        Element::file, 0,
        fmt::format("{}: has {} bytes; a binary STL file has at least 84, get it again", file.name(), file.size()));
  file.read(0, header);
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, &header[80], sizeof(triangles));
  const std::uint64_t needed = header_size + std::uint64_t{triangle_size} * triangles;
  if (std::string_view(header.data(), 5) == "solid" && needed != file.size())
    throw Error(Element::file, 0,
                file.name() + ": is STL as text, which cannot be streamed; convert it to binary STL or PLY");
  if (needed > file.size())
    throw Error(Element::file, 0,
                fmt::format("{}: announces {} triangles, for which the file is too short ({} bytes); it is cut off, "
                            "get it again",
                            file.name(), triangles, file.size()));
  Layout layout;
  layout.element = "corner";
  layout.begin = header_size;
  layout.records = triangles;
  layout.record_size = triangle_size;
  layout.points_per_record = 3;
  layout.point_size = 12;
  layout.normal = floats_at(0);
  layout.position = floats_at(12);
  layout.schema.normals = true;
  return layout;
}

Layout raw_layout(const SourceFile& file) {
  constexpr std::uint32_t point_size = 12;
  if (file.size() % point_size != 0)
    throw Error(Element::file, 0,
                fmt::format("{}: has {} bytes, which are no triples of floats; it is cut off or has another format",
                            file.name(), file.size()));
  Layout layout;
  layout.element = "point";
  layout.records = file.size() / point_size;
  layout.record_size = layout.point_size = point_size;
  layout.position = floats_at(0);
  return layout;
}

std::string format_of(const std::filesystem::path& file, const std::string& format) {
  if (!format.empty()) return lower(format.front() == '.' ? format : "." + format);
  const std::string ending = lower(file.extension().string());
  return ending == ".zst" ? lower(file.stem().extension().string()) : ending;
}

bool is_compressed(const std::filesystem::path& file) { return lower(file.extension().string()) == ".zst"; }

std::optional<Layout> layout_of(const SourceFile& file, const std::string& format) {
  if (format == ".ply") return ply_layout(file);
  if (format == ".las") {
    Layout layout = las_layout(read_las_header(file));
    read_byte_colours(file, layout);
    return layout;
  }
  if (format == ".stl") return stl_layout(file);
  if (format == ".raw") return raw_layout(file);
  if (format == ".xyz" || format == ".txt" || format == ".asc" || format == ".csv" || format == ".pts")
    return std::nullopt;
  if (format == ".laz")
    throw Error(Element::file, 0,
                file.name() +
                    ": LAZ is compressed, and no library of Debian reads it; decompress it first: laszip -i " +
                    file.name() + " -o scan.las, or pdal translate");
  if (format == ".e57")
    throw Error(Element::file, 0,
                file.name() +
                    ": no library of Debian reads E57; convert it first, for example with CloudCompare: "
                    "CloudCompare -SILENT -O " +
                    file.name() + " -C_EXPORT_FMT LAS -SAVE_CLOUDS");
  throw Error(
      Element::file, 0,
      file.name() + ": the ending \"" + format +
          "\" names no format that can be streamed; use .ply, .las, .stl, .xyz, .pts or .raw, or the option format");
}

}  // namespace glark::stream
