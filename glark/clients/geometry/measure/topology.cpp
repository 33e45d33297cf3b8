// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/topology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <utility>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::geometry {
namespace {

constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

std::uint64_t hash(std::span<const float> position) {
  std::uint64_t mixed = 0;
  for (const float coordinate : position) {
    mixed = (mixed ^ std::bit_cast<std::uint32_t>(coordinate + 0.0F)) * 0x9e3779b97f4a7c15ULL;  // -0 becomes 0
    mixed ^= mixed >> 29;
  }
  return mixed;
}

// Returns for each element the first equal element.
template <class Hash, class Same>
std::vector<std::uint32_t> first_of_same(std::size_t count, Hash&& hash_of, Same&& same) {
  const std::size_t slots = std::bit_ceil(2 * count + 1);
  std::vector<std::uint32_t> table(slots, empty);
  std::vector<std::uint32_t> first(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::size_t slot = hash_of(i) & (slots - 1);
    while (table[slot] != empty && !same(table[slot], i)) slot = (slot + 1) & (slots - 1);
    if (table[slot] == empty) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

template <class Value>
bool equal_rows(const std::vector<Value>& values, std::size_t width, std::size_t a, std::size_t b) {
  return values.empty() || std::equal(&values[width * a], &values[width * a] + width, &values[width * b]);
}

template <class Value>
void move_row(std::vector<Value>& values, std::size_t width, std::size_t from, std::size_t to) {
  if (!values.empty() && from != to) std::copy_n(&values[width * from], width, &values[width * to]);
}

using Corners = std::array<std::uint32_t, 3>;

// Most lists have three numbers, for which std::sort is slow.
void sort(std::span<std::uint32_t> list) {
  constexpr std::size_t many = 32;
  if (list.size() > many) return std::sort(list.begin(), list.end());
  for (std::size_t i = 1; i < list.size(); ++i) {
    const std::uint32_t value = list[i];
    std::size_t k = i;
    for (; k > 0 && list[k - 1] > value; --k) list[k] = list[k - 1];
    list[k] = value;
  }
}

// Visits the corners of triangles that are not degenerate. `place` gives the first point at the position of a point.
template <class Place, class Visit>
void each_triangle(const Geometry& geometry, Place&& place, Visit&& visit) {
  for (std::size_t i = 0; i < geometry.triangles.size(); i += 3) {
    const Corners corners{place(geometry.triangles[i]), place(geometry.triangles[i + 1]),
                          place(geometry.triangles[i + 2])};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) visit(corners);
  }
}

// Counts edges by the number of their triangles. Each edge is in the list of its lower corner, which is short.
template <class Place>
void count_edges(const Geometry& geometry, Place&& place, Topology& topology) {
  const auto each_edge = [&](auto&& visit) {
    each_triangle(geometry, place, [&](const Corners& corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
        visit(low, high);
      }
    });
  };
  std::vector<std::size_t> end(geometry.point_count() + 1);
  each_edge([&](std::uint32_t low, std::uint32_t) { ++end[low + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint32_t> highs(end.back());
  each_edge([&](std::uint32_t low, std::uint32_t high) { highs[end[low]++] = high; });
  for (std::size_t low = 0, begin = 0; low < geometry.point_count(); begin = end[low++]) {
    const auto list = std::span(highs).subspan(begin, end[low] - begin);
    sort(list);
    for (auto edge = list.begin(); edge != list.end();) {
      const auto next = std::find_if(edge, list.end(), [&](std::uint32_t other) { return other != *edge; });
      topology.boundary_edges += next - edge == 1 ? 1 : 0;
      topology.non_manifold_edges += next - edge > 2 ? 1 : 0;
      edge = next;
    }
  }
}

template <class Place>
common::DisjointSets components_by(const Geometry& geometry, Place&& place) {
  common::DisjointSets sets(geometry.point_count());
  each_triangle(geometry, place, [&](const Corners& corners) {
    sets.join(corners[0], corners[1]);
    sets.join(corners[1], corners[2]);
  });
  return sets;
}

// Returns the number of components that have triangles. The others are single points.
std::size_t count_of(common::DisjointSets components) {
  std::vector<bool> has_triangles(components.size());
  for (std::uint32_t i = 0; i < components.size(); ++i)
    if (const std::uint32_t component = components.find(i); component != i) has_triangles[component] = true;
  return static_cast<std::size_t>(std::count(has_triangles.begin(), has_triangles.end(), true));
}

}  // namespace

std::vector<std::uint32_t> first_at_same_place(std::span<const float> positions) {
  const auto hash_of = [&](std::uint32_t point) { return hash(positions.subspan(3 * std::size_t{point}, 3)); };
  const auto same = [&](std::uint32_t a, std::uint32_t b) {
    return std::equal(positions.begin() + 3 * std::ptrdiff_t{a}, positions.begin() + 3 * std::ptrdiff_t{a} + 3,
                      positions.begin() + 3 * std::ptrdiff_t{b});
  };
  return first_of_same(positions.size() / 3, hash_of, same);
}

void join_identical_points(Geometry& geometry) {
  const auto same = [&](std::uint32_t a, std::uint32_t b) {
    return equal_rows(geometry.positions, 3, a, b) && equal_rows(geometry.normals, 3, a, b) &&
           equal_rows(geometry.colours, 4, a, b) && equal_rows(geometry.texture_coordinates, 2, a, b);
  };
  const auto hash_of = [&](std::uint32_t point) {
    const std::span<const float> normals(geometry.normals);
    const std::size_t row = 3 * std::size_t{point};
    const std::uint64_t mixed = hash(std::span(geometry.positions).subspan(row, 3));
    return normals.empty() ? mixed : mixed ^ (hash(normals.subspan(row, 3)) << 1U);
  };
  const std::vector<std::uint32_t> first = first_of_same(geometry.point_count(), hash_of, same);
  std::vector<std::uint32_t> target(first.size());
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    target[i] = first[i] == i ? kept++ : target[first[i]];
    if (first[i] != i) continue;
    move_row(geometry.positions, 3, i, target[i]);
    move_row(geometry.normals, 3, i, target[i]);
    move_row(geometry.colours, 4, i, target[i]);
    move_row(geometry.texture_coordinates, 2, i, target[i]);
  }
  geometry.positions.resize(std::size_t{3} * kept);
  if (!geometry.normals.empty()) geometry.normals.resize(std::size_t{3} * kept);
  if (!geometry.colours.empty()) geometry.colours.resize(std::size_t{4} * kept);
  if (!geometry.texture_coordinates.empty()) geometry.texture_coordinates.resize(std::size_t{2} * kept);
  for (std::uint32_t& corner : geometry.triangles) corner = target[corner];
}

Topology topology_of(const Geometry& geometry) {
  Topology topology;
  const std::vector<std::uint32_t> first = first_at_same_place(geometry.positions);
  for (std::uint32_t i = 0; i < first.size(); ++i) topology.places += first[i] == i ? 1 : 0;
  if (geometry.triangles.empty()) return topology;

  const auto place = [&](std::uint32_t point) { return first[point]; };
  std::vector<char> used(first.size());
  for (const std::uint32_t point : geometry.triangles) used[point] = 1;
  topology.unused_points = static_cast<std::size_t>(std::count(used.begin(), used.end(), 0));
  count_edges(geometry, place, topology);
  common::DisjointSets components = components_by(geometry, place);
  std::vector<std::uint32_t> triangles_of(first.size());
  topology.degenerate_triangles = geometry.triangle_count();
  each_triangle(geometry, place, [&](const Corners& corners) {
    ++triangles_of[components.find(corners[0])];
    --topology.degenerate_triangles;
  });
  topology.largest_component = *std::max_element(triangles_of.begin(), triangles_of.end());
  topology.components = count_of(std::move(components));
  return topology;
}

Connections connections_of(const Geometry& geometry) {
  Topology topology;
  const std::vector<std::uint32_t> first = first_at_same_place(geometry.positions);
  const auto place = [&](std::uint32_t point) { return first[point]; };
  count_edges(geometry, place, topology);
  return {count_of(components_by(geometry, place)), topology.non_manifold_edges};
}

std::size_t component_count(const Geometry& geometry) {
  const std::size_t components = count_of(components_by(geometry, [](std::uint32_t point) { return point; }));
  if (components == 1) return components;  // positions join components, and only them
  const std::vector<std::uint32_t> first = first_at_same_place(geometry.positions);
  return count_of(components_by(geometry, [&](std::uint32_t point) { return first[point]; }));
}

}  // namespace glark::geometry
