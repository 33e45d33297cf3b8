// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_stream/edits.h"

#include <glark/stream.h>

#include <algorithm>
#include <cmath>

namespace glark::bench {
namespace {

constexpr double quarter = 1.5707963267948966;

template <class Step>
void each_point(const std::filesystem::path& file, const Step& step) {
  const auto reader = stream::open_points(file, {.channels = false});
  for (stream::Points points = reader->read(); points.size() > 0; points = reader->read()) step(points);
}

}  // namespace

double Box::diagonal() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]); }

Box box_of(const std::filesystem::path& file) {
  Box box;
  each_point(file, [&](const stream::Points& points) {
    for (std::size_t i = 0; i < points.positions.size(); ++i) {
      box.low[i % 3] = std::min(box.low[i % 3], points.positions[i]);
      box.high[i % 3] = std::max(box.high[i % 3], points.positions[i]);
    }
  });
  return box;
}

std::array<double, 3> edited(const std::string& edit, const Box& box, const std::array<double, 3>& p) {
  const double size = box.high[1] - box.low[1], t = (p[1] - box.low[1]) / size;
  const double x = p[0] - (box.low[0] + box.high[0]) / 2, z = p[2] - (box.low[2] + box.high[2]) / 2;
  if (edit == "bend") {
    const double r = size / quarter + x;
    return {r * std::cos(quarter * t), r * std::sin(quarter * t), p[2]};
  }
  if (edit == "twist") {
    const double c = std::cos(2 * quarter * t), s = std::sin(2 * quarter * t);
    return {c * x - s * z, p[1], s * x + c * z};
  }
  if (edit == "inflate") {
    const double scale = 1 + 0.1 * std::sin(2 * quarter * t);
    return {scale * x, p[1], scale * z};
  }
  return p;
}

void write_edited(const std::string& edit, const Box& box, const std::filesystem::path& from,
                  const std::filesystem::path& to) {
  const auto writer = stream::create_points(to, {stream::Number::float32, false, {}});
  each_point(from, [&](const stream::Points& points) {
    std::vector<double> positions;
    for (std::size_t i = 0; i < points.positions.size(); i += 3) {
      const std::array<double, 3> q =
          edited(edit, box, {points.positions[i], points.positions[i + 1], points.positions[i + 2]});
      positions.insert(positions.end(), q.begin(), q.end());
    }
    writer->write({points.first, positions, {}, {}});
  });
  writer->finish();
}

double error_of(const std::string& edit, const Box& box, const std::filesystem::path& scan,
                const std::filesystem::path& result) {
  const auto reader = stream::open_points(result, {.normals = false, .channels = false});
  double sum = 0;
  std::uint64_t count = 0;
  each_point(scan, [&](const stream::Points& points) {
    const stream::Points got = reader->read(points.size());
    for (std::size_t i = 0; i < points.positions.size(); i += 3) {
      const std::array<double, 3> q =
          edited(edit, box, {points.positions[i], points.positions[i + 1], points.positions[i + 2]});
      for (std::size_t k = 0; k < 3; ++k) sum += (got.positions[i + k] - q[k]) * (got.positions[i + k] - q[k]);
    }
    count += points.size();
  });
  return std::sqrt(sum / static_cast<double>(count)) / box.diagonal();
}

}  // namespace glark::bench
