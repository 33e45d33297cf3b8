// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/session/points_file.h"

#include <algorithm>

namespace glark::edit {
namespace {

constexpr const char* colour_names[] = {"red", "green", "blue"};

}  // namespace

Sampling read_sampling(const std::filesystem::path& file, std::size_t first) {
  const std::unique_ptr<stream::PointReader> reader = stream::open_points(file);
  if (first > 0) reader->seek(first);
  std::array<std::size_t, 3> colour{};
  for (std::size_t k = 0; k < 3; ++k) colour[k] = stream::channel_index(reader->schema(), colour_names[k]);
  const bool has_colours = std::find(colour.begin(), colour.end(), stream::none) == colour.end();
  const std::size_t width = reader->schema().channels.size();
  Sampling sampling;
  for (stream::Points points = reader->read(); points.size() > 0; points = reader->read()) {
    sampling.positions.insert(sampling.positions.end(), points.positions.begin(), points.positions.end());
    sampling.normals.insert(sampling.normals.end(), points.normals.begin(), points.normals.end());
    for (std::size_t i = 0; i < points.size() && has_colours; ++i)
      for (const std::size_t k : colour)
        sampling.colours.push_back(static_cast<std::uint8_t>(points.channels[width * i + k]));
  }
  return sampling;
}

void write_sampling(const std::filesystem::path& file, const SamplingView& sampling) {
  stream::Schema schema{stream::Number::float64, !sampling.normals.empty(), {}};
  for (const char* name : colour_names)
    if (!sampling.colours.empty()) schema.channels.push_back({name, stream::Number::uint8});
  const std::unique_ptr<stream::PointWriter> writer =
      stream::create_points(file, schema, sampling.positions.size() / 3);
  const std::vector<double> channels(sampling.colours.begin(), sampling.colours.end());
  writer->write({0, sampling.positions, sampling.normals, channels});
  writer->finish();
}

}  // namespace glark::edit
