// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/info/contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "glark/clients/geometry/formats.h"
#if GLARK_HAS_STREAM
#include "glark/tool/scan/info/records.h"
#endif
#include "glark/tool/scan/peak_memory.h"

namespace glark::tool {
namespace {

namespace fs = std::filesystem;

// Returns whether the file has the size that a binary STL file of its triangles has. What is read from a pipe is gone, so
// a pipe is none.
[[maybe_unused]] bool is_binary_stl(const fs::path& file) {
  constexpr std::uint64_t header_size = 84, triangle_size = 50;
  std::array<char, header_size> header{};
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  if (!std::ifstream(file, std::ios::binary).read(header.data(), header.size())) return false;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, &header[80], sizeof(triangles));
  return fs::file_size(file, error) == header_size + triangle_size * triangles;
}

// The format's ending in lower case, without that of the compression.
std::string format_of(const Files& files) {
  if (!files.format.empty()) return files.format;
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char letter) { return std::tolower(letter); });
    return text;
  };
  const fs::path path = files.input;
  const std::string ending = lower(path.extension().string());
  return ending == ".zst" ? lower(path.stem().extension().string()) : ending;
}

bool is_compressed(const Files& files) { return fs::path(files.input).extension() == ".zst"; }

bool can_summarise(const Files& files) { return geometry::can_summarise(path_of(files), {.format = files.format}); }

// glark-stream reads these formats a part at a time.
bool has_records([[maybe_unused]] const Files& files) {
#if GLARK_HAS_STREAM
  const std::string format = format_of(files);
  if (is_compressed(files)) return false;
  if (format == ".stl") return is_binary_stl(path_of(files));
  return format == ".las" || format == ".raw" || format == ".laz" || format == ".e57";
#else
  return false;
#endif
}

// The memory that reading the whole file and its topology take, relative to the size of the file. Measured: 2.1 for a
// mesh, 2.2 for points of three floats, 1.5 for text. Short rows take more.
double growth_of(const Files& files) {
  constexpr double of_records = 4, of_assimp = 8, of_compression = 4;
  return (can_summarise(files) ? of_records : of_assimp) * (is_compressed(files) ? of_compression : 1);
}

Report bounding_box(const geometry::Summary& summary) {
  Report report;
  report["low"] = summary.low;
  report["high"] = summary.high;
  report["diagonal"] =
      std::hypot(summary.high[0] - summary.low[0], summary.high[1] - summary.low[1], summary.high[2] - summary.low[2]);
  return report;
}

Report attributes_of(const geometry::Summary& summary) {
  Report names = Report::array();
  if (summary.normals) names.push_back("normals");
  if (summary.colours) names.push_back("colours");
  if (summary.texture_coordinates) names.push_back("texture_coordinates");
  return names;
}

geometry::Summary summary_of(const Files& files, Report& attributes) {
#if GLARK_HAS_STREAM
  if (has_records(files)) {
    Records records = count_records(path_of(files), format_of(files), files.skip_invalid);
    attributes = attributes_of(records.summary);
    for (const std::string& channel : records.other_channels) attributes.push_back(channel);
    return std::move(records.summary);
  }
#endif
  Progress progress("reading " + files.input);
  geometry::Summary summary =
      geometry::summarise_file(path_of(files), {.skip_invalid = files.skip_invalid, .format = files.format},
                               [&](double fraction) { progress.show(fraction); });
  attributes = attributes_of(summary);
  return summary;
}

}  // namespace

fs::path path_of(const Files& files) { return files.input == "-" ? "/dev/stdin" : files.input; }

bool must_read_in_parts(const Files& files, const Memory& memory) {
  const std::string format = format_of(files);
  if (has_records(files) && format != ".stl") return true;
  std::error_code error;
  const bool has_size = fs::is_regular_file(path_of(files), error);
  if (!has_size) return memory.is_given && can_summarise(files);
  const double needed = growth_of(files) * static_cast<double>(fs::file_size(path_of(files)));
  if (needed <= static_cast<double>(memory.bytes)) return false;
  if (can_summarise(files) || has_records(files)) return true;
  if (memory.is_given)
    throw std::runtime_error(fmt::format(
        "{}: this format can only be read as a whole, which takes about {:.0f} MB; give so much with --memory, or "
        "convert the file to PLY",
        files.input, needed / 1e6));
  return false;
}

Report contents_in_parts(const Files& files) {
  Report attributes;
  const geometry::Summary summary = summary_of(files, attributes);
  for (const std::string& warning : summary.warnings) warn(files.input + ": " + warning);
  Report report;
  report["file"] = files.input;
  // The whole reading counts corners of STL at one place as one point.
  report[format_of(files) == ".stl" ? "corners" : "points"] = summary.points;
  report["triangles"] = summary.triangles;
  report["attributes"] = attributes;
  report["bounding_box"] = bounding_box(summary);
  if (summary.origin != std::array<double, 3>{}) report["origin"] = summary.origin;
  report["peak_memory_bytes"] = peak_memory();
  return report;
}

}  // namespace glark::tool
