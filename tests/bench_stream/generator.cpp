// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_stream/generator.h"

#include <glark/stream.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "glark/clients/geometry/formats.h"

namespace glark::bench {
namespace {

constexpr int slices = 256;

// A number from 0 to 1 that belongs to the point.
double random_of(std::uint64_t i, std::uint64_t which) {
  std::uint64_t x = i * 0x9E3779B97F4A7C15U + which * 0xD1B54A32D192ED03U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

double area_of(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c) {
  std::array<double, 3> u{}, v{};
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
  }
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

}  // namespace

ScanGenerator::ScanGenerator(const std::filesystem::path& model, const ScanOptions& options) : options_(options) {
  const geometry::Geometry mesh = geometry::read_file(model, {}).geometry;
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], static_cast<double>(mesh.positions[i]));
    high[i % 3] = std::max(high[i % 3], static_cast<double>(mesh.positions[i]));
  }
  diagonal_ = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::array<Corner, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t at = 3 * std::size_t{mesh.triangles[t + c]} + k;
        triangle[c].position[k] = static_cast<double>(mesh.positions[at]);
        triangle[c].normal[k] = mesh.normals.empty() ? 0 : static_cast<double>(mesh.normals[at]);
      }
    triangles_.push_back(triangle);
  }
  const auto place = [&](const std::array<Corner, 3>& t) {
    std::array<double, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = (t[0].position[k] + t[1].position[k] + t[2].position[k]) / 3;
    const double slice = std::floor(slices * (c[axis] - low[axis]) / (high[axis] - low[axis]));
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    return std::pair(slice, std::atan2(c[v] - (low[v] + high[v]) / 2, c[u] - (low[u] + high[u]) / 2));
  };
  std::vector<std::pair<std::pair<double, double>, std::size_t>> order;
  for (std::size_t t = 0; t < triangles_.size(); ++t) order.emplace_back(place(triangles_[t]), t);
  std::sort(order.begin(), order.end());
  std::vector<std::array<Corner, 3>> sorted;
  double area = 0;
  for (const auto& [where, t] : order) {
    sorted.push_back(triangles_[t]);
    area += area_of(sorted.back()[0].position, sorted.back()[1].position, sorted.back()[2].position);
    areas_.push_back(area);
  }
  triangles_ = std::move(sorted);
  // The product of an index and the step must not overflow.
  if (options.shuffled && options.points >> 32 != 0)
    throw std::invalid_argument("a shuffled scan has less than 2^32 points");
  step_ = options.points * 618 / 1000 | 1U;
  while (std::gcd(step_, options.points) != 1) step_ += 2;
}

void ScanGenerator::point(std::uint64_t i, double* position, float* normal) const {
  if (options_.shuffled) i = i * step_ % options_.points;
  const double area = areas_.back() * (static_cast<double>(i) + 0.5) / static_cast<double>(options_.points);
  const auto t = static_cast<std::size_t>(std::lower_bound(areas_.begin(), areas_.end(), area) - areas_.begin());
  const std::array<Corner, 3>& triangle = triangles_[std::min(t, triangles_.size() - 1)];
  const double root = std::sqrt(random_of(i, 1)), w = random_of(i, 2);
  const std::array<double, 3> weights{1 - root, root * (1 - w), root * w};
  std::array<double, 3> n{};
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] = n[k] = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      position[k] += weights[c] * triangle[c].position[k];
      n[k] += weights[c] * triangle[c].normal[k];
    }
  }
  const double length = std::max(1e-30, std::hypot(n[0], n[1], n[2]));
  const double wave = 400 / diagonal_;
  const double height = diagonal_ * (options_.detail * std::sin(wave * position[0]) * std::sin(wave * position[1]) *
                                         std::sin(wave * position[2]) +
                                     options_.noise * (2 * random_of(i, 3) - 1));
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] += height * n[k] / length;
    normal[k] = static_cast<float>(n[k] / length);
  }
}

void write_scan(const ScanGenerator& generator, std::uint64_t points, const std::filesystem::path& file) {
  constexpr std::size_t block = 4096;
  const auto writer = stream::create_points(file, {stream::Number::float32, true, {}}, points);
  std::vector<double> positions(3 * block);
  std::vector<float> normals(3 * block);
  for (std::uint64_t done = 0; done < points;) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(block, points - done));
    for (std::size_t i = 0; i < count; ++i) generator.point(done + i, &positions[3 * i], &normals[3 * i]);
    writer->write({done, std::span(positions).first(3 * count), std::span(normals).first(3 * count), {}});
    done += count;
  }
  writer->finish();
}

}  // namespace glark::bench
