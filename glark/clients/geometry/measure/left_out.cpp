// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/left_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace glark::geometry {
namespace {

using Place = std::array<double, 3>;

// The cells are so many that three of their numbers fit into 64 bits.
constexpr double most_cells = 1 << 20;
// The cell of all places far below the points; it is no neighbour of the cell of a point.
constexpr double outside = -3;

Place place_of(const Geometry& geometry, std::size_t point) {
  const float* position = &geometry.positions[3 * point];
  return {position[0], position[1], position[2]};
}

// Cubes near the surface of a mesh. Triangles may be larger than cubes, so points all over each triangle mark cubes.
class CellsNearMesh {
 public:
  CellsNearMesh(const Geometry& mesh, const Place& low, double side) : low_(low), side_(side) {
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
      mark(place_of(mesh, mesh.triangles[i]), place_of(mesh, mesh.triangles[i + 1]),
           place_of(mesh, mesh.triangles[i + 2]));
  }

  bool has_near(const Place& place) const {
    const Cell cell = cell_of(place);
    if (cells_.contains(key_of(cell))) return true;
    for (std::int64_t neighbour = 0; neighbour < 27; ++neighbour)
      if (cells_.contains(
              key_of({cell[0] + neighbour % 3 - 1, cell[1] + neighbour / 3 % 3 - 1, cell[2] + neighbour / 9 - 1})))
        return true;
    return false;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Place& place) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] =
          static_cast<std::int64_t>(std::floor(std::clamp((place[axis] - low_[axis]) / side_, outside, most_cells)));
    return cell;
  }

  static std::uint64_t key_of(const Cell& cell) {
    const auto number = [](std::int64_t value) { return static_cast<std::uint64_t>(value + 4); };
    return (number(cell[0]) << 42U) | (number(cell[1]) << 21U) | number(cell[2]);
  }

  void mark(const Place& a, const Place& b, const Place& c) {
    double longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      longest =
          std::max({longest, std::abs(b[axis] - a[axis]), std::abs(c[axis] - a[axis]), std::abs(c[axis] - b[axis])});
    const auto steps = static_cast<std::size_t>(std::ceil(2 * longest / side_)) + 1;
    for (std::size_t i = 0; i <= steps; ++i) {
      for (std::size_t k = 0; i + k <= steps; ++k) {
        const double u = static_cast<double>(i) / static_cast<double>(steps);
        const double v = static_cast<double>(k) / static_cast<double>(steps);
        Place sample{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          sample[axis] = a[axis] + u * (b[axis] - a[axis]) + v * (c[axis] - a[axis]);
        const std::uint64_t key = key_of(cell_of(sample));
        if (key != last_) cells_.insert(key);
        last_ = key;
      }
    }
  }

  Place low_;
  double side_;
  std::uint64_t last_ = 0;
  std::unordered_set<std::uint64_t> cells_;
};

}  // namespace

std::size_t points_left_out(const Geometry& points, const Geometry& mesh, double distance) {
  if (points.positions.empty()) return 0;
  Place low = place_of(points, 0);
  Place high = low;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], static_cast<double>(points.positions[i]));
    high[i % 3] = std::max(high[i % 3], static_cast<double>(points.positions[i]));
  }
  // Each place of the mesh has a sample within .29 sides, so the cells around a point see all of the mesh within a side.
  constexpr double slack = 1.5;
  constexpr double most_across = 2048;  // bounds the samples on a large triangle
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const CellsNearMesh cells(mesh, low, std::max(slack * distance, extent / most_across));
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.point_count(); ++i) count += cells.has_near(place_of(points, i)) ? 0 : 1;
  return count;
}

}  // namespace glark::geometry
