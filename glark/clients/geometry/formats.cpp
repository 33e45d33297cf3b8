// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/formats.h"

#include <algorithm>
#include <cctype>

#include "glark/clients/geometry/parse/input.h"
#include "glark/clients/geometry/read/assimp_reader.h"
#include "glark/clients/geometry/read/off_reader.h"
#include "glark/clients/geometry/read/pcd_reader.h"
#include "glark/clients/geometry/read/ply_reader.h"
#include "glark/clients/geometry/read/text_points.h"
#include "glark/clients/geometry/write/writers.h"

namespace glark::geometry {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

std::string ending_of(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".zst" ? lower(file.stem().extension().string()) : ending;
}

std::string format_of(const fs::path& file, const ReadOptions& options) {
  const std::string& format = options.format;
  if (format.empty()) return ending_of(file);
  return lower(format.front() == '.' ? format : "." + format);
}

bool is_text(const std::string& format) {
  return format == ".xyz" || format == ".txt" || format == ".asc" || format == ".csv" || format == ".pts";
}

// progress must live as long as the input.
Input open_with_progress(const fs::path& file, const Progress& progress) {
  Input input = open_input(file);
  if (!progress) return input;
  const double size = input.remaining() ? static_cast<double>(*input.remaining()) : 0;
  input.on_progress(
      [&progress, size](std::uint64_t bytes) { progress(size > 0 ? static_cast<double>(bytes) / size : -1); });
  return input;
}

Reading read_as(const std::string& ending, Input& input, const ReadOptions& options) {
  if (ending == ".ply") return read_ply(input, options);
  if (ending == ".obj") return read_by_assimp(input, MeshFormat::obj, options);
  if (ending == ".stl") return read_by_assimp(input, MeshFormat::stl, options);
  if (ending == ".off") return read_off(input, options);
  if (ending == ".glb" || ending == ".gltf") return read_by_assimp(input, MeshFormat::gltf, options);
  if (ending == ".pcd") return read_pcd(input, options);
  if (is_text(ending)) return read_text_points(input, ending == ".pts" ? TextPoints::pts : TextPoints::xyz, options);
  throw Error(input.name() + ": the ending \"" + ending +
              "\" names no format that glark reads; use .ply, .obj, .stl, .off, .glb, .pcd, .xyz or .pts (or one of "
              "these and .zst), or the option format");
}

void check_ending(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  for (const char* known : {".ply", ".obj", ".stl", ".xyz", ".pts", ".glb"})
    if (ending == known) return;
  throw Error(file.string() + ": the ending \"" + ending +
              "\" names no format that glark writes; use .ply, .obj, .stl, .xyz, .pts or .glb");
}

}  // namespace

Reading read_file(const fs::path& file, const ReadOptions& options, const Progress& progress) {
  Input input = open_with_progress(file, progress);
  return read_as(format_of(file, options), input, options);
}

bool can_summarise(const fs::path& file, const ReadOptions& options) {
  const std::string format = format_of(file, options);
  return format == ".ply" || format == ".pcd" || is_text(format);
}

Summary summarise_file(const fs::path& file, const ReadOptions& options, const Progress& progress) {
  const std::string format = format_of(file, options);
  if (!can_summarise(file, options))
    throw Error(file.string() + ": the format \"" + format + "\" can only be read as a whole; convert the file to PLY");
  Input input = open_with_progress(file, progress);
  if (format == ".ply") return summarise_ply(input, options);
  if (format == ".pcd") return summarise_pcd(input, options);
  return summarise_text_points(input, format == ".pts" ? TextPoints::pts : TextPoints::xyz, options);
}

void check_writable(const fs::path& file) {
  check_ending(file);
  const OutputFile trial(file);
}

void write_file(const fs::path& file, const Geometry& geometry, const WriteOptions& options) {
  check_ending(file);
  const std::string ending = lower(file.extension().string());
  OutputFile output(file);
  if (ending == ".ply") write_ply(output, geometry, options.text ? PlyEncoding::text : PlyEncoding::binary);
  if (ending == ".obj") write_obj(output, geometry);
  if (ending == ".stl") write_stl(output, geometry, file.string());
  if (ending == ".xyz") write_xyz(output, geometry);
  if (ending == ".pts") write_pts(output, geometry);
  if (ending == ".glb") write_glb(output, geometry, file.string());
  output.commit();
}

}  // namespace glark::geometry
