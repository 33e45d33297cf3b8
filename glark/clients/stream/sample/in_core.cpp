// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/in_core.h"

#include <glark/vstree.h>

#include <algorithm>
#include <mutex>

#include "glark/clients/stream/files/with_vstree.h"
#include "glark/clients/stream/sample/pass/local_points.h"

namespace glark::stream {
namespace {

// The memory of vstree::simplify() with its input and its result. Measured with points that fill a volume, which take
// more than those of a surface.
constexpr double base_bytes = 16 << 20;      // of the program
constexpr double least_bytes_a_point = 290;  // of the memory that the caller allows
struct InCoreBytes {
  double a_point, a_sample;
};
constexpr InCoreBytes with_normals{160, 480};
constexpr InCoreBytes without_normals{400, 250};  // while normals are estimated

struct AllPoints {
  std::array<double, 3> origin{};
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;
  std::uint64_t left_out = 0;
};

AllPoints read_points(BlockSource& source, const PointKind& kind, const Progress& progress) {
  AllPoints all;
  const auto count = static_cast<std::size_t>(source.count().value_or(0));
  all.positions.reserve(3 * count);
  std::uint64_t done = 0;
  const auto keep = [&](const Points& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* position = &points.positions[3 * i];
      if (!std::isfinite(position[0] + position[1] + position[2])) {
        ++all.left_out;
        continue;
      }
      if (all.positions.empty() && source.schema().position == Number::float64)
        std::copy_n(position, 3, all.origin.begin());
      for (std::size_t k = 0; k < 3; ++k) all.positions.push_back(static_cast<float>(position[k] - all.origin[k]));
      if (kind.has_normals) {
        const std::array<float, 3> normal = unit_normal_of(points, i);
        all.normals.insert(all.normals.end(), normal.begin(), normal.end());
      }
      const std::array<std::uint8_t, 4> colour = kind.colour_of(points, i);
      if (kind.has_colours()) all.colours.insert(all.colours.end(), colour.begin(), colour.begin() + 3);
    }
  };
  // A piece at a time is read by one thread, so that the points keep their order.
  for (std::uint64_t read = 1; read > 0; done += read) {
    if (progress && done > 0) progress(0.3 * static_cast<double>(done) / static_cast<double>(count));
    read = source.each(done, done + BlockSource::piece, keep);
  }
  return all;
}

}  // namespace

bool fits_in_core(std::uint64_t points, bool has_normals, const SampleOptions& options) {
  const InCoreBytes bytes = has_normals ? with_normals : without_normals;
  const std::uint64_t samples = options.target == 0 ? points : std::min<std::uint64_t>(options.target, points);
  const double all =
      base_bytes + bytes.a_point * static_cast<double>(points) + bytes.a_sample * static_cast<double>(samples);
  return std::max(all, least_bytes_a_point * static_cast<double>(points)) <= static_cast<double>(options.memory);
}

Schema sampling_schema(const Schema& source, bool has_colours) {
  Schema schema{source.position, true, {}};
  if (has_colours)
    for (const char* name : {"red", "green", "blue"}) schema.channels.push_back({name, Number::uint8});
  return schema;
}

SampleReport sample_in_core(BlockSource& source, const SampleOptions& options, const CreateWriter& create) {
  const PointKind kind(source.schema());
  const AllPoints all = read_points(source, kind, options.progress);
  if (options.progress) options.progress(0.3);
  vstree::SimplifyOptions how;
  how.target = options.target;
  how.threshold = static_cast<float>(options.error);
  how.metric = vstree::Metric::qef;
  how.threads = options.threads;
  const vstree::PointSet points{.positions = all.positions, .normals = all.normals, .colours = all.colours};
  const vstree::Simplified coarse =
      with_vstree(source.name(), [&] { return vstree::simplify({.points = points}, how); });
  if (options.progress) options.progress(0.9);
  std::vector<double> positions, channels(coarse.colours.begin(), coarse.colours.end());
  for (std::size_t i = 0; i < coarse.positions.size(); ++i)
    positions.push_back(all.origin[i % 3] + static_cast<double>(coarse.positions[i]));
  const std::unique_ptr<PointWriter> writer = create(sampling_schema(source.schema(), kind.has_colours()));
  writer->write({0, positions, coarse.normals, channels});
  writer->finish();

  SampleReport report;
  report.in_core = true;
  report.left_out = all.left_out;
  report.points = all.positions.size() / 3 + all.left_out;
  report.samples = positions.size() / 3;
  SampledCell cell;
  std::array<double, 3> high{};
  for (std::size_t i = 0; i < all.positions.size(); ++i) {
    const double at = all.origin[i % 3] + static_cast<double>(all.positions[i]);
    cell.corner[i % 3] = i < 3 ? at : std::min(cell.corner[i % 3], at);
    high[i % 3] = i < 3 ? at : std::max(high[i % 3], at);
  }
  for (std::size_t k = 0; k < 3; ++k) cell.side = std::max(cell.side, high[k] - cell.corner[k]);
  cell.points = report.points - report.left_out;
  cell.last = report.points == 0 ? 0 : report.points - 1;
  cell.samples = report.samples;
  report.cells.push_back(cell);
  return report;
}

}  // namespace glark::stream
