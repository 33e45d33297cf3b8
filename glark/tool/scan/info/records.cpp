// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/tool/scan/info/records.h"

#include <fmt/format.h>
#include <glark/point_stream.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "glark/tool/scan/console.h"

namespace glark::tool {
namespace {

bool is_finite(std::span<const double> position) {
  return std::all_of(position.begin(), position.end(), [](double value) { return std::isfinite(value); });
}

// Counts the finite points and widens the bounding box by them. With triangles, three points follow one another for each.
void add_points(const stream::Points& points, bool are_triangles, geometry::Summary& summary) {
  std::size_t corners = 0;  // finite ones of the triangle
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto position = points.positions.subspan(3 * i, 3);
    corners = i % 3 == 0 ? 0 : corners;
    if (!is_finite(position)) continue;
    ++summary.points;
    if (++corners == 3 && are_triangles) ++summary.triangles;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      summary.low[axis] = std::min(summary.low[axis], position[axis]);
      summary.high[axis] = std::max(summary.high[axis], position[axis]);
    }
  }
}

// The colours count as one attribute.
std::vector<std::string> channels_besides_colours(const stream::Schema& schema) {
  std::vector<std::string> names;
  for (const stream::Channel& channel : schema.channels)
    if (channel.name != "red" && channel.name != "green" && channel.name != "blue") names.push_back(channel.name);
  return names;
}

}  // namespace

Records count_records(const std::filesystem::path& file, const std::string& format, bool skip_invalid) {
  Progress progress("reading " + file.string());
  const auto schema = stream::open_points(file, {.format = format})->schema();
  const auto reader =
      stream::open_points(file, {.format = format, .normals = false, .channels = false, .keep_invalid = skip_invalid});
  Records records;
  geometry::Summary& summary = records.summary;
  summary.low.fill(std::numeric_limits<double>::infinity());
  summary.high.fill(-std::numeric_limits<double>::infinity());
  constexpr std::size_t part = 3072;  // whole triangles
  std::uint64_t read = 0;
  for (auto points = reader->read(part); points.size() > 0; points = reader->read(part)) {
    add_points(points, format == ".stl", summary);
    read += points.size();
    if (reader->count()) progress.show(static_cast<double>(read) / static_cast<double>(*reader->count()));
  }
  if (summary.points == 0) throw std::runtime_error(file.string() + ": it has no points; export it again");
  if (summary.points < read)
    summary.warnings.push_back(
        fmt::format("{} points with NaN or infinite coordinates are left out", read - summary.points));
  summary.normals = schema.normals && format != ".stl";  // STL has the normals of faces
  summary.colours = stream::channel_index(schema, "red") != stream::none;
  records.other_channels = channels_besides_colours(schema);
  return records;
}

}  // namespace glark::tool
