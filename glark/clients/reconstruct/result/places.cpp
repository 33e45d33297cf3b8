// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/result/places.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include "glark/clients/common/float4.h"
#include "glark/clients/common/mesh/cut_sheets.h"
#include "glark/clients/common/mesh/reindex.h"

namespace glark::reconstruct {
namespace {

using namespace common;

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr float apart = 0.02F;  // of the way to the middle of a vertex's triangles
constexpr int most_rounds = 8;

Float4 point_at(std::span<const float> positions, std::uint32_t vertex) {
  const float* const position = &positions[3 * std::size_t{vertex}];
  return Float4{position[0], position[1], position[2], 0};
}

std::size_t hash_of(const float* position) {
  std::uint64_t mixed = 0;
  for (int k = 0; k < 3; ++k) {
    mixed = (mixed ^ std::bit_cast<std::uint32_t>(position[k] + 0.0F)) * 0x9E3779B97F4A7C15U;  // -0 becomes 0
    mixed ^= mixed >> 29U;
  }
  return mixed;
}

// For each vertex, the first one at the same position.
struct Places {
  std::vector<std::uint32_t> first;
  bool are_shared = false;  // whether any position has two vertices

  explicit Places(std::span<const float> positions) : first(positions.size() / 3) {
    const std::size_t mask = std::bit_ceil(2 * first.size() + 1) - 1;
    std::vector<std::uint32_t> table(mask + 1, none);
    for (std::uint32_t i = 0; i < first.size(); ++i) {
      const float* const own = &positions[3 * std::size_t{i}];
      std::size_t slot = hash_of(own) & mask;
      while (table[slot] != none && !std::equal(own, own + 3, &positions[3 * std::size_t{table[slot]}]))
        slot = (slot + 1) & mask;
      are_shared |= table[slot] != none;
      if (table[slot] == none) table[slot] = i;
      first[i] = table[slot];
    }
  }
};

struct Edge {
  std::uint32_t low, high;  // places
  std::uint32_t triangles;
};

// Calls visit(edge) for each edge. The edges are sorted by counting, by their lower ends.
template <typename Visit>
void each_edge(const Places& places, std::span<const std::uint32_t> triangles, const Visit& visit) {
  const auto each_side = [&](const auto& body) {
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      const std::array<std::uint32_t, 3> at{places.first[triangles[t]], places.first[triangles[t + 1]],
                                            places.first[triangles[t + 2]]};
      if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
      for (std::size_t k = 0; k < 3; ++k) body(std::min(at[k], at[(k + 1) % 3]), std::max(at[k], at[(k + 1) % 3]));
    }
  };
  std::vector<std::uint32_t> ends(places.first.size() + 1);
  each_side([&](std::uint32_t low, std::uint32_t) { ++ends[low + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::uint32_t> highs(ends.back());
  each_side([&](std::uint32_t low, std::uint32_t high) { highs[ends[low]++] = high; });
  for (std::uint32_t low = 0, begin = 0; low < places.first.size(); begin = ends[low++]) {
    const auto list = std::span(highs).subspan(begin, ends[low] - begin);
    std::sort(list.begin(), list.end());
    for (auto at = list.begin(); at != list.end();) {
      const auto next = std::find_if(at, list.end(), [&](std::uint32_t other) { return other != *at; });
      visit(Edge{low, *at, static_cast<std::uint32_t>(next - at)});
      at = next;
    }
  }
}

// Moves the vertices at the marked places.
void move(std::span<float> positions, std::span<const float> normals, std::span<const std::uint32_t> triangles,
          const Places& places, const std::vector<bool>& is_crowded, bool along_normals) {
  const auto moves = [&](std::uint32_t vertex) { return is_crowded[places.first[vertex]]; };
  std::vector<std::uint32_t> number(places.first.size(), none), moved;
  for (const std::uint32_t i : triangles) {
    if (!moves(i) || number[i] != none) continue;
    number[i] = static_cast<std::uint32_t>(moved.size());
    moved.push_back(i);
  }
  std::vector<Float4> sums(moved.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const std::uint32_t* const v = &triangles[t];
    if (!moves(v[0]) && !moves(v[1]) && !moves(v[2])) continue;
    Float4 middle = (point_at(positions, v[0]) + point_at(positions, v[1]) + point_at(positions, v[2])) / 3;
    middle[3] = 1;
    for (int k = 0; k < 3; ++k) {
      if (number[v[k]] != none) sums[number[v[k]]] += middle;
    }
  }
  std::vector<Float4> ways(moved.size());
  float size = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    ways[i] = without_fourth(sums[i] / sums[i][3]) - point_at(positions, moved[i]);
    size += std::sqrt(dot(ways[i], ways[i])) / static_cast<float>(moved.size());
  }
  std::vector<std::uint32_t> before(along_normals ? places.first.size() : 0);  // vertices at the same place
  for (std::size_t i = 0; i < moved.size(); ++i) {
    Float4 way = ways[i];
    if (along_normals) {
      const auto rank = static_cast<float>(++before[places.first[moved[i]]]);
      way += point_at(normals, moved[i]) * (rank * std::max(size, std::sqrt(dot(way, way))));
    }
    for (std::size_t k = 0; k < 3; ++k) positions[3 * std::size_t{moved[i]} + k] += apart * way[static_cast<int>(k)];
  }
}

}  // namespace

EdgeCounts count_edges(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  EdgeCounts counts;
  each_edge(Places(positions), triangles, [&](const Edge& edge) {
    counts.non_manifold += edge.triangles > 2 ? 1 : 0;
    if (edge.triangles != 1) return;
    const Float4 along = point_at(positions, edge.high) - point_at(positions, edge.low);
    ++counts.boundary;
    counts.boundary_length += static_cast<double>(std::sqrt(dot(along, along)));
  });
  return counts;
}

std::vector<std::uint32_t> cut_at_edges(std::span<const float> positions, std::vector<std::uint32_t>& triangles) {
  std::vector<Float4> points;
  for (std::uint32_t i = 0; i < positions.size() / 3; ++i) points.push_back(point_at(positions, i));
  return cut_sheets(triangles, points, irregular_vertices(triangles, points.size()));
}

void part_places(std::span<float> positions, std::span<const float> normals, std::span<const std::uint32_t> triangles) {
  for (int round = 0; round < most_rounds; ++round) {
    const Places places(positions);
    if (!places.are_shared) return;
    std::vector<bool> is_crowded(places.first.size());
    bool any = false;
    each_edge(places, triangles, [&](const Edge& edge) {
      if (edge.triangles <= 2) return;
      is_crowded[edge.low] = is_crowded[edge.high] = any = true;
    });
    if (!any) return;
    move(positions, normals, triangles, places, is_crowded, round > 0);
  }
}

}  // namespace glark::reconstruct
