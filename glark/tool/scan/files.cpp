// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "glark/clients/geometry/formats.h"

namespace glark::tool {
namespace {

// Returns the number of names (hard links) that a regular file has besides `file`; 0 if there is no such file.
std::uintmax_t other_names(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return 0;
  const std::uintmax_t names = std::filesystem::hard_link_count(file, error);
  return error || names == 0 ? 0 : names - 1;
}

}  // namespace

void describe_input(CLI::App& command, Files& files, const std::vector<std::string>& more_formats) {
  std::vector<std::string> formats{"ply", "obj", "stl", "off", "glb", "gltf", "pcd", "xyz", "pts"};
  formats.insert(formats.end(), more_formats.begin(), more_formats.end());
  command
      .add_option("FILE", files.input,
                  fmt::format("Points or a mesh: .{}, also compressed with a second ending .zst; - is standard input",
                              fmt::join(formats, ", .")))
      ->required();
  command
      .add_option_function<std::string>(
          "--format", [&files](const std::string& name) { files.format = "." + name; },
          "The format of FILE, whatever its name is")
      ->check(CLI::IsMember(formats))
      ->type_name("NAME");
  command.add_flag("--skip-invalid", files.skip_invalid,
                   "Leave out points with NaN or infinite coordinates instead of stopping");
  command.add_flag("--json", files.json, "Report as JSON on standard output");
}

void describe_output(CLI::App& command, Files& files) {
  command.add_option("-o,--output", files.output, "The file to write: .ply, .obj, .stl, .xyz, .pts or .glb")
      ->type_name("OUT")
      ->required();
  command.add_flag("--text", files.text, "Write PLY as text");
}

void describe_threads(CLI::App& command, unsigned& threads) {
  command.add_option("--threads", threads, "Most threads; default: all of the machine. The result is the same");
}

void check_output(const Files& files) { geometry::check_writable(files.output); }

geometry::Geometry load(const std::string& file, const Files& files, bool with_images, bool all_points) {
  Progress progress("reading " + file);
  // --format is about the input, not about the reference of --measure.
  const bool is_input = file == files.input;
  geometry::Reading reading = geometry::read_file(file == "-" ? "/dev/stdin" : file,
                                                  {.skip_invalid = files.skip_invalid,
                                                   .format = is_input ? files.format : "",
                                                   .images = with_images,
                                                   .all_points = all_points},
                                                  [&](double fraction) { progress.show(fraction); });
  for (const std::string& warning : reading.warnings) warn(file + ": " + warning);
  return std::move(reading.geometry);
}

namespace {

void warn_of_coarse_floats(const geometry::Geometry& geometry, const std::string& output) {
  std::string ending = std::filesystem::path(output).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return std::tolower(letter); });
  double farthest = 0;
  for (const double origin : geometry.origin) farthest = std::max(farthest, std::abs(origin));
  if (ending == ".stl" && farthest > 0)
    warn(fmt::format("{}: STL has floats, which are {:.2g} apart so far from zero; PLY, OBJ and XYZ keep the digits",
                     output, farthest * 0x1p-23));
}

}  // namespace

void store(const geometry::Geometry& geometry, const Files& files) {
  const Progress progress("writing " + files.output);
  const std::uintmax_t others = other_names(files.output);
  geometry::write_file(files.output, geometry, {.text = files.text});
  warn_of_coarse_floats(geometry, files.output);
  if (others > 0)
    warn(fmt::format("{}: other hard links to the old file keep the old contents: {}", files.output, others));
}

Report contents_of(const geometry::Geometry& geometry) {
  Report report;
  report["points"] = geometry.point_count();
  report["triangles"] = geometry.triangle_count();
  Report attributes = Report::array();
  if (!geometry.normals.empty()) attributes.push_back("normals");
  if (!geometry.colours.empty()) attributes.push_back("colours");
  if (!geometry.texture_coordinates.empty()) attributes.push_back("texture_coordinates");
  report["attributes"] = attributes;
  return report;
}

}  // namespace glark::tool
