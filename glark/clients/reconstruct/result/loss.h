// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measures which points a mesh does not represent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "glark/clients/reconstruct/samples/octree.h"

namespace glark::reconstruct {

// A finished mesh, in the unit of the points.
struct MeshView {
  std::span<const float> positions;          // [3 * vertices]
  std::span<const float> normals;            // [3 * vertices], or empty
  std::span<const std::uint32_t> triangles;  // [3 * triangles]
};

// The result of looking at some of the points. If these are all points, it is exact.
struct Loss {
  std::size_t points = 0;    // points with a normal that are no outliers
  std::size_t measured = 0;  // of these, the points that were looked at
  std::size_t lost = 0;      // of these, the points that the mesh does not represent

  double share() const { return measured > 0 ? static_cast<double>(lost) / static_cast<double>(measured) : 0; }
};

inline constexpr std::size_t most_measured = 20000;  // points that are looked at

// A point is lost if it is farther from all triangles that face the same way than three times the distance of the points around it, plus three
// times their noise, plus `tolerance`. Both are those of the nearest points that face the same way, so neither several
// sheets in one place nor other parts of the cloud change them. The points are spread evenly over the cloud, and the
// same ones each time.
// outliers: the indices of points that do not count, in ascending order. tolerance: in the points' unit.
Loss loss_of(const PointSet& points, std::span<const std::uint32_t> outliers, const MeshView& mesh, float tolerance,
             const Workers& workers);

}  // namespace glark::reconstruct
