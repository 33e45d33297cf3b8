// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/grid/cells.h"

#include <algorithm>
#include <span>

namespace glark::stream {
namespace {

void divide(std::span<const Cube> cubes, unsigned level, const CellLimits& limits, std::vector<Cell>& cells) {
  if (cubes.empty()) return;
  std::uint64_t count = 0;
  for (const Cube& cube : cubes) count += cube.count;
  if (level == limits.least_level || (count <= limits.points && level <= limits.most_level)) {
    Cell cell{.key = cubes.front().key >> (3 * level) << (3 * level), .level = level, .count = count};
    for (const Cube& cube : cubes) {
      cell.first = std::min(cell.first, cube.first);
      cell.last = std::max(cell.last, cube.last);
    }
    cells.push_back(cell);
    return;
  }
  const unsigned shift = 3 * (level - 1);
  while (!cubes.empty()) {
    const std::uint64_t child = cubes.front().key >> shift;
    const auto end =
        std::find_if(cubes.begin(), cubes.end(), [&](const Cube& cube) { return cube.key >> shift != child; });
    const auto size = static_cast<std::size_t>(end - cubes.begin());
    divide(cubes.first(size), level - 1, limits, cells);
    cubes = cubes.subspan(size);
  }
}

}  // namespace

std::vector<Cell> cells_of(const std::vector<Cube>& cubes, const CellLimits& limits) {
  std::vector<Cell> cells;
  divide(cubes, Lattice::levels, limits, cells);
  return cells;
}

double most_open_points(const std::vector<Cell>& cells) {
  struct Event {
    std::uint64_t at;
    double slope, start;  // open points of the cell at t: slope * t + start
  };
  std::vector<Event> events;
  events.reserve(2 * cells.size());
  for (const Cell& cell : cells) {
    const double slope = static_cast<double>(cell.count) / static_cast<double>(cell.last - cell.first + 1);
    const double start = -slope * static_cast<double>(cell.first);
    events.push_back({cell.first, slope, start});
    events.push_back({cell.last + 1, -slope, -start});
  }
  std::sort(events.begin(), events.end(),
            [](const Event& a, const Event& b) { return a.at != b.at ? a.at < b.at : a.slope > b.slope; });
  double slope = 0, start = 0, most = 0;
  for (const Event& event : events) {
    most = std::max(most, slope * static_cast<double>(event.at) + start);
    slope += event.slope;
    start += event.start;
  }
  return most;
}

std::size_t cell_of(const std::vector<Cell>& cells, std::uint64_t key) {
  const auto after =
      std::upper_bound(cells.begin(), cells.end(), key, [](std::uint64_t k, const Cell& cell) { return k < cell.key; });
  if (after == cells.begin()) return none;
  const Cell& cell = *(after - 1);
  const bool is_inside = key >> (3 * cell.level) == cell.key >> (3 * cell.level);
  return is_inside ? static_cast<std::size_t>(after - 1 - cells.begin()) : none;
}

}  // namespace glark::stream
