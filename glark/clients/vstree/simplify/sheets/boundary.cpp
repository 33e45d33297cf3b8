// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/sheets/boundary.h"

#include <algorithm>
#include <bit>

#include "glark/clients/common/mixed_bits.h"

namespace glark::vstree {
namespace {

// Returns 1 for each cluster at the boundary of the clusters' triangles. Around another cluster, each neighbour follows
// one triangle and precedes another.
std::vector<std::uint8_t> at_boundary(const Clusters& clusters, bool& any) {
  std::vector<std::uint32_t> sums(clusters.count);
  const std::vector<std::uint32_t>& corners = clusters.triangles;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const std::uint32_t a = common::mixed_bits(corners[t]), b = common::mixed_bits(corners[t + 1]),
                        c = common::mixed_bits(corners[t + 2]);
    sums[corners[t]] += b - c;
    sums[corners[t + 1]] += c - a;
    sums[corners[t + 2]] += a - b;
  }
  std::vector<std::uint8_t> result(clusters.count);
  for (std::size_t i = 0; i < sums.size(); ++i) result[i] = sums[i] != 0 ? 1 : 0;
  any = std::ranges::any_of(result, [](std::uint8_t flag) { return flag != 0; });
  return result;
}

std::uint64_t key_of(const Surface& surface, std::uint32_t point) {
  std::uint32_t low = 0, high = 0x9E3779B9U;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto bits = std::bit_cast<std::uint32_t>(surface.points.positions[3 * std::size_t{point} + k] + 0.0F);
    low = common::mixed_bits(low ^ bits);
    high = common::mixed_bits(high + bits);
  }
  return std::uint64_t{high} << 32 | low;
}

struct Found {
  std::uint64_t key;  // of both ends, in any order
  BoundaryEdge edge;
};

}  // namespace

std::vector<BoundaryEdge> boundary_edges(const Surface& surface, const Clusters& clusters) {
  bool any = false;
  const std::vector<std::uint8_t> is_at_boundary = at_boundary(clusters, any);
  if (!any) return {};
  std::vector<Found> found;
  const std::span<const std::uint32_t> triangles = surface.triangles;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const std::uint32_t* const v = &triangles[t];
    const bool flags[3] = {is_at_boundary[clusters.of[v[0]]] != 0, is_at_boundary[clusters.of[v[1]]] != 0,
                           is_at_boundary[clusters.of[v[2]]] != 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (!flags[k] && !flags[next]) continue;
      const std::uint64_t from = key_of(surface, v[k]), to = key_of(surface, v[next]);
      if (from != to) found.push_back({from + to, {v[k], v[next], v[(k + 2) % 3]}});
    }
  }
  std::ranges::stable_sort(found, {}, &Found::key);
  std::vector<BoundaryEdge> result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_shared =
        (i > 0 && found[i - 1].key == found[i].key) || (i + 1 < found.size() && found[i + 1].key == found[i].key);
    if (!is_shared) result.push_back(found[i].edge);
  }
  return result;
}

Float4 boundary_normal(Float4 from, Float4 to, Float4 opposite) {
  const Float4 along = without_fourth(to - from);
  return unit(cross(along, cross(along, without_fourth(opposite - from))));
}

BoundaryPlanes::BoundaryPlanes(const Surface& surface, const std::vector<BoundaryEdge>& edges)
    : is_at_boundary_(surface.size()) {
  for (const BoundaryEdge& edge : edges) {
    const Float4 normal =
        boundary_normal(surface.point(edge.from), surface.point(edge.to), surface.point(edge.opposite));
    if (!(dot(normal, normal) > 0)) continue;
    for (const std::uint32_t end : {edge.from, edge.to}) {
      is_at_boundary_[end] = true;
      normals_.emplace(end, normal);
    }
  }
}

}  // namespace glark::vstree
