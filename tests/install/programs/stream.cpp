// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/stream.h>

#include <cstdio>
#include <filesystem>

#include "sphere_points.h"

int main() {
  namespace stream = glark::stream;
  const std::vector<float> points = sphere_points(1000);
  const std::vector<double> positions(points.begin(), points.end());
  const std::filesystem::path large = "stream_large.ply", small = "stream_small.ply";
  const auto writer = stream::create_points(large, {});
  writer->write({0, positions, {}, {}});
  writer->finish();
  stream::SampleOptions options;
  options.target = 100;
  const stream::SampleReport report = stream::sample_file(large, small, options);
  for (const char* file : {"stream_large.ply", "stream_small.ply", "stream_small.ply.cells"}) std::remove(file);
  return report.points == 1000 && report.samples > 50 ? 0 : 1;
}
