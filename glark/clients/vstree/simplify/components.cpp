// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/components.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::vstree {
namespace {

constexpr std::size_t few = 8;    // parts that may break off a sound result
constexpr std::size_t small = 8;  // triangles of a part; if parts have fewer on average, their vertices are not shared

// Counts the parts of triangles that share vertices. `sets` may have joined some vertices before.
std::size_t count_parts(std::span<const std::uint32_t> triangles, common::DisjointSets& sets) {
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    sets.join(triangles[t], triangles[t + 1]);
    sets.join(triangles[t], triangles[t + 2]);
  }
  std::vector<bool> is_seen(sets.size());
  std::size_t count = 0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const std::uint32_t part = sets.find(triangles[t]);
    count += is_seen[part] ? 0 : 1;
    is_seen[part] = true;
  }
  return count;
}

// Points at one position are one vertex.
common::DisjointSets joined_by_position(std::span<const float> positions) {
  const auto place = [&](std::uint32_t i) {
    return std::array{positions[3 * std::size_t{i}], positions[3 * std::size_t{i} + 1],
                      positions[3 * std::size_t{i} + 2]};
  };
  std::vector<std::uint32_t> order(positions.size() / 3);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  common::DisjointSets sets(order.size());
  for (std::size_t k = 1; k < order.size(); ++k)
    if (place(order[k - 1]) == place(order[k])) sets.join(order[k - 1], order[k]);
  return sets;
}

std::size_t parts_of(const Surface& surface) {
  common::DisjointSets sets(surface.size());
  const std::size_t parts = count_parts(surface.triangles, sets);
  if (parts <= surface.triangles.size() / 3 / small) return parts;
  // Most triangles have corners of their own. Positions tell which ones are neighbours.
  common::DisjointSets by_position = joined_by_position(surface.points.positions);
  return count_parts(surface.triangles, by_position);
}

}  // namespace

bool falls_apart(const Surface& from, const Simplified& result) {
  common::DisjointSets sets(result.positions.size() / 3);
  const std::size_t parts = count_parts(result.triangles, sets);
  return parts > few && parts > 2 * parts_of(from) + few;
}

}  // namespace glark::vstree
