// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_stream/quality.h"

#include <glark/stream.h>

#include <cmath>
#include <vector>

#include "glark/clients/stream/samples/sample_index.h"
#include "tests/bench_stream/edits.h"

namespace glark::bench {

double distance_of(const std::filesystem::path& scan, const std::filesystem::path& sampling, std::uint64_t step) {
  std::vector<common::Vector3f> positions, normals;
  const auto samples = stream::open_points(sampling);
  for (stream::Points points = samples->read(); points.size() > 0; points = samples->read())
    for (std::size_t i = 0; i < points.size(); ++i) {
      positions.push_back({static_cast<float>(points.positions[3 * i]), static_cast<float>(points.positions[3 * i + 1]),
                           static_cast<float>(points.positions[3 * i + 2])});
      normals.push_back(common::vector_at(points.normals, i));
    }
  const stream::SampleIndex index(positions);
  std::vector<stream::NearSample> near;
  double sum = 0;
  std::uint64_t count = 0;
  const auto reader = stream::open_points(scan, {.normals = false, .channels = false});
  for (stream::Points points = reader->read(); points.size() > 0; points = reader->read())
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((points.first + i) % step != 0) continue;
      const common::Vector3f p{static_cast<float>(points.positions[3 * i]),
                               static_cast<float>(points.positions[3 * i + 1]),
                               static_cast<float>(points.positions[3 * i + 2])};
      index.nearest(p, 1, near);
      const auto distance = static_cast<double>(common::dot(p - positions[near[0].index], normals[near[0].index]));
      sum += distance * distance;
      ++count;
    }
  return std::sqrt(sum / static_cast<double>(count)) / box_of(scan).diagonal();
}

}  // namespace glark::bench
