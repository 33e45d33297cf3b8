// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/charts/islands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/maps/charts/triangle2.h"

namespace glark::maps {
namespace {

constexpr float rounding = 1e-4F;       // coordinates may be beyond 0 to 1 by this
constexpr double most_without = 0.001;  // of the surface, that has no area in the texture
constexpr double most_shared = 0.002;   // of the area in the texture, that several triangles cover

float doubled_area(const Surface& surface, std::uint32_t t) { return Triangle2{surface.texcoords[t]}.doubled_area(); }

std::string fault_of_range(const Surface& surface) {
  float low = 0, high = 1;
  for (const auto& corners : surface.texcoords) {
    for (const Point2& corner : corners) {
      if (!std::isfinite(corner[0]) || !std::isfinite(corner[1]))
        return "a texture coordinate of it is not a finite number";
      low = std::min({low, corner[0], corner[1]});
      high = std::max({high, corner[0], corner[1]});
    }
  }
  if (low >= -rounding && high <= 1 + rounding) return {};
  return fmt::format("its texture coordinates go from {:.3g} to {:.3g}, beyond 0 to 1", low, high);
}

std::string fault_of_areas(const Surface& surface) {
  double all = 0, without = 0;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const auto area = static_cast<double>(common::length(
        common::cross(surface.positions[b] - surface.positions[a], surface.positions[c] - surface.positions[a])));
    all += area;
    if (doubled_area(surface, t) == 0) without += area;
  }
  if (without <= most_without * all) return {};
  return fmt::format("{:.3g} % of its surface has texture coordinates without an area", 100 * without / all);
}

// Counts the cells of a grid that triangles cover.
std::string fault_of_overlaps(const Surface& surface) {
  constexpr float inside = 0.03F;  // triangles that share an edge do not overlap by this weight
  constexpr double cells_of_triangle = 48, least_side = 256, most_side = 8192;
  double area = 0;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    area += std::abs(static_cast<double>(doubled_area(surface, t))) / 2;
  const double cells = cells_of_triangle * static_cast<double>(surface.triangles.size()) / std::max(area, 1e-9);
  const auto side = static_cast<std::size_t>(std::clamp(std::sqrt(cells), least_side, most_side));
  std::vector<bool> covered(side * side);
  std::size_t once = 0, again = 0;
  for (const auto& corners : surface.texcoords) {
    Triangle2 triangle{corners};
    for (Point2& corner : triangle.corners)
      for (float& x : corner) x *= static_cast<float>(side);
    for_each_centre(triangle, inside, [&](int x, int y, const Weights&) {
      const auto limit = static_cast<int>(side);
      if (x < 0 || y < 0 || x >= limit || y >= limit) return;
      const std::size_t at = static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x);
      ++(covered[at] ? again : once);
      covered[at] = true;
    });
  }
  const double shared = static_cast<double>(again) / static_cast<double>(std::max<std::size_t>(once + again, 1));
  if (shared <= most_shared) return {};
  return fmt::format("{:.3g} % of the area of its texture coordinates lies on other parts of them", 100 * shared);
}

// Whether the neighbour across an edge continues the triangle in the texture.
bool continues(const Surface& surface, std::uint32_t t, std::size_t edge) {
  const std::uint32_t other = surface.neighbours[t][edge];
  if (other == none || (doubled_area(surface, t) < 0) != (doubled_area(surface, other) < 0)) return false;
  for (const std::size_t k : {edge, (edge + 1) % 3})
    if (surface.texcoords[t][k] != surface.texcoords[other][corner_at(surface, other, surface.triangles[t][k])])
      return false;
  return true;
}

}  // namespace

std::string fault_of_texcoords(const Surface& surface) {
  if (surface.texcoords.empty()) return "it has no texture coordinates";
  for (const auto& fault_of : {fault_of_range, fault_of_areas, fault_of_overlaps})
    if (std::string fault = fault_of(surface); !fault.empty()) return fault;
  return {};
}

std::vector<Chart> islands_of(const Surface& surface) {
  std::vector<bool> is_taken(surface.triangles.size());
  std::vector<Chart> islands;
  for (std::uint32_t first = 0; first < surface.triangles.size(); ++first) {
    if (is_taken[first]) continue;
    Chart& island = islands.emplace_back();
    island.is_own = true;
    island.is_mirrored = doubled_area(surface, first) < 0;
    island.triangles.push_back(first);
    is_taken[first] = true;
    for (std::size_t i = 0; i < island.triangles.size(); ++i) {
      const std::uint32_t t = island.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = surface.neighbours[t][k];
        if (!continues(surface, t, k) || is_taken[other]) continue;
        is_taken[other] = true;
        island.triangles.push_back(other);
      }
    }
    lay_out(island, surface);
  }
  return islands;
}

std::vector<Chart> join_islands(const std::vector<Chart>& islands, const Surface& surface) {
  std::vector<Chart> joined;
  for (const bool is_mirrored : {false, true}) {
    Chart chart;
    chart.is_own = true;
    chart.is_mirrored = is_mirrored;
    for (const Chart& island : islands)
      if (island.is_mirrored == is_mirrored)
        chart.triangles.insert(chart.triangles.end(), island.triangles.begin(), island.triangles.end());
    if (chart.triangles.empty()) continue;
    lay_out(chart, surface);
    joined.push_back(std::move(chart));
  }
  return joined;
}

}  // namespace glark::maps
