// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench_points/measure/mesh_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "tests/bench_points/measure/surface_distance.h"

namespace glark::bench {
namespace {

using Point = std::array<double, 3>;

Point point_at(std::span<const float> positions, std::size_t i) {
  return {static_cast<double>(positions[3 * i]), static_cast<double>(positions[3 * i + 1]),
          static_cast<double>(positions[3 * i + 2])};
}

struct OneWay {
  double rms = 0, greatest = 0;
};

// Measures from random points of one surface, and from its vertices.
OneWay from_to(const MeshView& from, const MeshView& to, std::size_t samples) {
  const SurfaceDistance distance(to.positions, to.triangles);
  OneWay result;
  double sum = 0;
  const std::vector<float> points = samples_of(from.positions, from.triangles, samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const double square = distance.squared(point_at(points, i));
    sum += square;
    result.greatest = std::max(result.greatest, square);
  }
  for (const std::uint32_t vertex : from.triangles)
    result.greatest = std::max(result.greatest, distance.squared(point_at(from.positions, vertex)));
  result.rms = std::sqrt(sum / static_cast<double>(samples));
  result.greatest = std::sqrt(result.greatest);
  return result;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::map<Edge, int> edges_by_position(const MeshView& mesh) {
  const std::vector<std::uint32_t> triangles = welded(mesh);
  std::map<Edge, int> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i], b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    if (a != b) ++edges[std::minmax(a, b)];
  }
  return edges;
}

struct Segment {
  Point from, to;
};

std::vector<Segment> borders_of(const MeshView& mesh) {
  std::vector<Segment> result;
  for (const auto& [edge, count] : edges_by_position(mesh)) {
    if (count == 1) result.push_back({point_at(mesh.positions, edge.first), point_at(mesh.positions, edge.second)});
  }
  return result;
}

double distance_of(const Point& point, const Segment& segment) {
  double along = 0, length = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (point[i] - segment.from[i]) * (segment.to[i] - segment.from[i]);
    length += (segment.to[i] - segment.from[i]) * (segment.to[i] - segment.from[i]);
  }
  const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i)
    square += std::pow(point[i] - segment.from[i] - t * (segment.to[i] - segment.from[i]), 2);
  return std::sqrt(square);
}

double border_distance(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  double greatest = 0;
  for (const Segment& segment : from) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      Point point{};
      for (std::size_t i = 0; i < 3; ++i) point[i] = segment.from[i] + t * (segment.to[i] - segment.from[i]);
      double least = std::numeric_limits<double>::infinity();
      for (const Segment& other : to) least = std::min(least, distance_of(point, other));
      greatest = std::max(greatest, least);
    }
  }
  return greatest;
}

}  // namespace

std::vector<std::uint32_t> welded(const MeshView& mesh) {
  std::map<std::array<float, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (const std::uint32_t i : mesh.triangles) {
    const std::array<float, 3> place{mesh.positions[3 * i] + 0.0F, mesh.positions[3 * i + 1] + 0.0F,
                                     mesh.positions[3 * i + 2] + 0.0F};
    result.push_back(first.try_emplace(place, i).first->second);
  }
  return result;
}

std::size_t non_manifold_by_position(const MeshView& mesh) {
  std::size_t count = 0;
  for (const auto& [edge, triangles] : edges_by_position(mesh)) count += triangles > 2 ? 1 : 0;
  return count;
}

MeshDistances distances_between(const MeshView& original, const MeshView& result, std::size_t samples) {
  const double percent = 100 / diagonal_of(original.positions);
  const OneWay there = from_to(original, result, samples), back = from_to(result, original, samples);
  const std::vector<Segment> borders = borders_of(original), others = borders_of(result);
  MeshDistances distances{std::max(there.rms, back.rms) * percent, std::max(there.greatest, back.greatest) * percent,
                          0};
  if (!borders.empty())
    distances.borders =
        others.empty() ? 100 : std::max(border_distance(borders, others), border_distance(others, borders)) * percent;
  return distances;
}

}  // namespace glark::bench
