// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The boundary of an open surface, which a simplification keeps.
#pragma once

#include <unordered_map>
#include <vector>

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// Returns the edges of the surface's boundary that have an end in a cluster at the boundary of the clusters' triangles.
// Holes that close within the clusters are left out. On a closed surface, no triangle is examined.
std::vector<BoundaryEdge> boundary_edges(const Surface& surface, const Clusters& clusters);

// Planes through the edges of a boundary, perpendicular to their triangles, for the points at their ends.
class BoundaryPlanes {
 public:
  BoundaryPlanes(const Surface& surface, const std::vector<BoundaryEdge>& edges);

  // Calls use(normal) for each plane through the point. The normals have unit length.
  template <typename Use>
  void at(std::uint32_t point, const Use& use) const {
    if (!is_at_boundary_[point]) return;
    const auto [begin, end] = normals_.equal_range(point);
    for (auto i = begin; i != end; ++i) use(i->second);
  }

 private:
  std::vector<bool> is_at_boundary_;
  std::unordered_multimap<std::uint32_t, Float4> normals_;
};

// Returns the unit normal of the plane through a boundary edge, or zero.
Float4 boundary_normal(Float4 from, Float4 to, Float4 opposite);

}  // namespace glark::vstree
