// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/overlap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "glark/clients/maps/charts/triangle2.h"

namespace glark::maps {
namespace {

constexpr float least_cosine = 0.05F;    // of a triangle's normal and the chart's
constexpr float cells_of_triangle = 48;  // so many cells of the grid does a triangle cover on average
constexpr float inside = 0.03F;          // triangles that share an edge do not overlap by this weight

// The first two triangles that cover the same place. A grid of cells finds overlaps larger than a cell.
std::optional<std::pair<std::uint32_t, std::uint32_t>> find_overlap(const Chart& chart, const Surface& surface) {
  const float area = std::max(chart.size[0] * chart.size[1], 1e-30F);
  const float cell = std::sqrt(area / (cells_of_triangle * static_cast<float>(chart.triangles.size())));
  std::unordered_map<std::uint64_t, std::uint32_t> owner;
  for (const std::uint32_t t : chart.triangles) {
    Triangle2 triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 p = chart.project(surface.positions[surface.triangles[t][k]]);
      triangle.corners[k] = {(p[0] - chart.low[0]) / cell, (p[1] - chart.low[1]) / cell};
    }
    std::optional<std::uint32_t> other;
    for_each_centre(triangle, inside, [&](int x, int y, const Weights&) {
      const auto key =
          (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32U) | static_cast<std::uint32_t>(x);
      const auto [place, is_new] = owner.emplace(key, t);
      if (!is_new) other = place->second;
    });
    if (other) return std::pair(*other, t);
  }
  return std::nullopt;
}

// Returns the triangles that are nearer to the second seed than to the first, counted in triangles.
std::vector<std::uint32_t> nearer_to_second(const Chart& chart, const Surface& surface, std::uint32_t first,
                                            std::uint32_t second) {
  std::unordered_map<std::uint32_t, bool> side;
  std::vector<std::uint32_t> front{first, second};
  side[first] = false;
  side[second] = true;
  for (std::size_t i = 0; i < front.size(); ++i) {
    for (const std::uint32_t neighbour : surface.neighbours[front[i]]) {
      if (neighbour == none || side.contains(neighbour) ||
          !std::binary_search(chart.triangles.begin(), chart.triangles.end(), neighbour))
        continue;
      side[neighbour] = side[front[i]];
      front.push_back(neighbour);
    }
  }
  std::vector<std::uint32_t> nearer;
  for (const std::uint32_t t : chart.triangles)
    if (const auto found = side.find(t); found != side.end() && found->second) nearer.push_back(t);
  return nearer;
}

std::vector<std::uint32_t> facing_away(const Chart& chart, const Surface& surface) {
  std::vector<std::uint32_t> away;
  for (const std::uint32_t t : chart.triangles) {
    const Vector& normal = surface.triangle_normals[t];
    if (!common::is_zero(normal) && common::dot(normal, chart.normal) < least_cosine) away.push_back(t);
  }
  return away;
}

}  // namespace

Chart cut_overlap(Chart& chart, const Surface& surface) {
  Chart rest;
  if (chart.triangles.size() < 2) return rest;
  std::vector<std::uint32_t> cut = facing_away(chart, surface);
  if (cut.size() == chart.triangles.size()) cut.pop_back();
  if (cut.empty()) {
    const auto overlap = find_overlap(chart, surface);
    if (!overlap) return rest;
    cut = nearer_to_second(chart, surface, overlap->first, overlap->second);
  }
  std::erase_if(chart.triangles, [&](std::uint32_t t) { return std::binary_search(cut.begin(), cut.end(), t); });
  rest.triangles = std::move(cut);
  return rest;
}

}  // namespace glark::maps
