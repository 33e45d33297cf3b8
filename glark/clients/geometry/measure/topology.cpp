// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/topology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

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

void count_edges(std::vector<std::uint64_t>& edges, Topology& topology) {
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(edge, edges.end(), [&](std::uint64_t other) { return other != *edge; });
    topology.boundary_edges += next - edge == 1 ? 1 : 0;
    topology.non_manifold_edges += next - edge > 2 ? 1 : 0;
    edge = next;
  }
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

  std::vector<bool> used(first.size());
  std::vector<std::uint64_t> edges;
  edges.reserve(geometry.triangles.size());
  common::DisjointSets sets(first.size());
  const auto corner = [&](std::size_t index) { return first[geometry.triangles[index]]; };
  for (std::size_t i = 0; i < geometry.triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) used[geometry.triangles[i + k]] = true;
    const std::array corners{corner(i), corner(i + 1), corner(i + 2)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      ++topology.degenerate_triangles;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
      edges.push_back(std::uint64_t{low} << 32U | high);
    }
    sets.join(corners[0], corners[1]);
    sets.join(corners[1], corners[2]);
  }
  topology.unused_points = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  count_edges(edges, topology);
  std::vector<std::uint32_t> triangles_of(first.size());
  for (std::size_t i = 0; i < geometry.triangles.size(); i += 3)
    if (corner(i) != corner(i + 1) && corner(i + 1) != corner(i + 2) && corner(i + 2) != corner(i))
      ++triangles_of[sets.find(corner(i))];
  topology.components = static_cast<std::size_t>(
      std::count_if(triangles_of.begin(), triangles_of.end(), [](std::uint32_t count) { return count > 0; }));
  topology.largest_component = *std::max_element(triangles_of.begin(), triangles_of.end());
  return topology;
}

}  // namespace glark::geometry
