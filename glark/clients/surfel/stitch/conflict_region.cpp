// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/stitch/conflict_region.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "glark/clients/surfel/stitch/agreement.h"
#include "glark/clients/surfel/stitch/hole_filling.h"
#include "glark/clients/surfel/stitch/triangle_cost.h"

namespace glark::surfel {
namespace {

constexpr float slack = 1e-3F;               // the overlap of sectors that rounding may cause
constexpr std::size_t most_hole_edges = 32;  // longer loops are boundaries of the surface
constexpr float penalty = 1000;              // the cost factor of back-facing triangles and of existing edges

}  // namespace

void ConflictRegion::begin(std::span<const std::uint32_t> points) {
  points_ = points;
  if (fans_.size() < points.size()) fans_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    fans_[i].begin(level_.positions[points[i]], point_normal(level_, points[i]));
  }
  drawn_.clear();
}

// Returns null for points outside the region.
VertexFan* ConflictRegion::fan_of(std::uint32_t point) {
  return level_.region_of[point] == points_.front() ? &fans_[number_in_region_[point]] : nullptr;
}

VertexFan::Sector ConflictRegion::sector_of(const VertexFan& fan, std::uint32_t first, std::uint32_t second) const {
  VertexFan::Sector sector{first, second, fan.angle_of(level_.positions[first]), 0};
  const float to = fan.angle_of(level_.positions[second]);
  sector.angle = wrapped(to - sector.from);
  if (sector.angle <= full_turn / 2) return sector;
  // Without normals, each point has an orientation of its own.
  if (!options_.has_normals) return {second, first, to, full_turn - sector.angle};
  sector.angle = -1;
  return sector;
}

void ConflictRegion::add_agreed(const Triangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    VertexFan* const fan = fan_of(triangle[k]);
    if (fan != nullptr) fan->sectors.push_back(sector_of(*fan, triangle[(k + 1) % 3], triangle[(k + 2) % 3]));
  }
}

void ConflictRegion::insert(const Triangle& triangle) {
  add_agreed(triangle);
  drawn_.push_back(triangle);
}

// Returns whether the triangle overlaps no other triangle at its corners, and shares no half-edge with one.
bool ConflictRegion::fits(const Triangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const VertexFan* const fan = fan_of(triangle[k]);
    const VertexFan::Sector sector = sector_of(*fan, triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
    for (const VertexFan::Sector& other : fan->sectors) {
      if (other.first == sector.first || other.second == sector.second) return false;
      if (sector.angle < 0 || other.angle < 0) continue;
      if (wrapped(other.from - sector.from) < sector.angle - slack) return false;
      if (wrapped(sector.from - other.from) < other.angle - slack) return false;
    }
  }
  return true;
}

void ConflictRegion::stitch(std::vector<ConflictingTriangle>& conflicting) {
  std::sort(conflicting.begin(), conflicting.end(), [](const ConflictingTriangle& a, const ConflictingTriangle& b) {
    return std::tie(a.missing, a.cost, a.triangle) < std::tie(b.missing, b.cost, b.triangle);
  });
  for (const ConflictingTriangle& one : conflicting) {
    if (fits(one.triangle)) insert(one.triangle);
  }
  if (options_.has_normals) fill_holes();
  std::erase_if(drawn_, [&](const Triangle& triangle) { return is_isolated(triangle); });
}

// Returns whether no other triangle has an edge of this triangle.
bool ConflictRegion::is_isolated(const Triangle& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& sectors = fan_of(triangle[k])->sectors;
    const std::uint32_t next = triangle[(k + 1) % 3];
    if (std::count_if(sectors.begin(), sectors.end(), [next](const VertexFan::Sector& sector) {
          return sector.first == next || sector.second == next;
        }) > 1) {
      return false;
    }
  }
  return true;
}

bool ConflictRegion::has_edge(std::uint32_t from, std::uint32_t to) {
  const VertexFan* const fan = fan_of(from);
  return std::any_of(fan->sectors.begin(), fan->sectors.end(),
                     [to](const VertexFan::Sector& sector) { return sector.first == to || sector.second == to; });
}

// Follows the boundary of a hole from the edge before .. at. Returns the end of the next boundary edge in clockwise
// order around `at`, or `none`.
std::uint32_t ConflictRegion::next_on_boundary(std::uint32_t before, std::uint32_t at) {
  const VertexFan* const fan = fan_of(at);
  if (fan == nullptr) return none;
  const auto begins_sector = [&](std::uint32_t point) {
    return std::any_of(fan->sectors.begin(), fan->sectors.end(),
                       [=](const VertexFan::Sector& sector) { return sector.first == point; });
  };
  const float from = fan->angle_of(level_.positions[before]);
  std::uint32_t next = none;
  float least = full_turn + 1;
  for (const VertexFan::Sector& sector : fan->sectors) {
    if (sector.second == before || begins_sector(sector.second)) continue;
    const float angle = wrapped(from - fan->angle_of(level_.positions[sector.second]));
    if (angle >= least) continue;
    least = angle;
    next = sector.second;
  }
  return next;
}

void ConflictRegion::fill_holes() {
  for (const std::uint32_t start : points_) {
    const VertexFan* const fan = fan_of(start);
    for (std::size_t i = 0; i < fan->sectors.size(); ++i) {
      const std::uint32_t before = fan->sectors[i].first;
      const bool has_neighbour = std::any_of(fan->sectors.begin(), fan->sectors.end(),
                                             [=](const auto& sector) { return sector.second == before; });
      if (!has_neighbour && fan_of(before) != nullptr) fill_hole_at(before, start);
    }
  }
}

// Fills the hole at the boundary edge before .. start, if the hole is closed and small.
void ConflictRegion::fill_hole_at(std::uint32_t before, std::uint32_t start) {
  path_ = {before, start};
  while (path_.size() <= 2 * most_hole_edges) {
    const std::uint32_t next = next_on_boundary(path_[path_.size() - 2], path_.back());
    if (next == none) return;
    const auto visited = std::find(path_.begin(), path_.end(), next);
    if (visited != path_.end()) return fill({&*visited, static_cast<std::size_t>(path_.end() - visited)});
    path_.push_back(next);
  }
}

// The reach does not limit triangles whose edges are no longer than the longest edge around the hole.
float ConflictRegion::fill_cost(const Triangle& triangle, float squared_longest) const {
  const Corners corners = sorted_corners(triangle[0], triangle[1], triangle[2]);
  if (!is_in_reach(level_, corners, options_.reach) && squared_longest_edge(level_, corners) > squared_longest)
    return infinite_cost;
  const float cost = triangle_cost(level_, triangle);
  return cost < 0 ? -cost * penalty : cost;
}

// Returns whether the loop is not a hole, but the outer boundary of a small piece of surface. Then its filling is
// back-facing, and its points have no other triangles than the piece. The points of a fold have more triangles.
bool ConflictRegion::is_outer_boundary(std::span<const std::uint32_t> loop) {
  Vector area, normals;
  float angles = 0;
  const Vector from = level_.positions[loop[0]];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    area = area + cross(level_.positions[loop[i]] - from, level_.positions[loop[(i + 1) % loop.size()]] - from);
    normals = normals + point_normal(level_, loop[i]);
    for (const VertexFan::Sector& sector : fan_of(loop[i])->sectors) angles += std::max(sector.angle, 0.0F);
  }
  constexpr float back_facing = -0.5F;
  const float interior_angles = full_turn / 2 * static_cast<float>(loop.size() - 2);
  return angles < interior_angles + full_turn / 2 && dot(unit(area), unit(normals)) < back_facing;
}

void ConflictRegion::fill(std::span<const std::uint32_t> loop) {
  const std::size_t corners = loop.size();
  if (corners < 3 || corners > most_hole_edges || is_outer_boundary(loop)) return;
  float squared_longest = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    const Vector edge = level_.positions[loop[i]] - level_.positions[loop[(i + 1) % corners]];
    squared_longest = std::max(squared_longest, dot(edge, edge));
  }
  const auto chord_factor = [&](std::size_t i, std::size_t j) {
    return j - i + 1 < corners && has_edge(loop[i], loop[j]) ? penalty : 1.0F;
  };
  const auto cost = [&](std::size_t i, std::size_t k, std::size_t j) {
    return fill_cost({loop[i], loop[k], loop[j]}, squared_longest);
  };
  for (const auto& [i, k, j] : fill_hole(corners, chord_factor, cost)) insert({loop[i], loop[k], loop[j]});
}

}  // namespace glark::surfel
