// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks the points that a caller gives, and brings them into the unit cube.
#pragma once

#include <glark/vstree.h>

#include <algorithm>

#include "glark/clients/common/points/record.h"
#include "glark/clients/common/workers.h"

namespace glark::common {

// Throws Error for arrays whose sizes do not fit, and for numbers that are not finite or out of range.
void check(const vstree::PointSet& points, const Workers& workers);

// The points must have passed check().
Cube bounding_cube(std::span<const float> positions, const Workers& workers);

inline Float4 unit_normal(const float* normal) {
  Float4 n{normal[0], normal[1], normal[2], 0};
  const float square = dot(n, n);
  if (square < 0.999F || square > 1.001F) {
    if (!(square > 1e-30F) || square > 1e30F) {  // the square leaves the range of floats: scale first
      const float most = std::max({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
      if (most == 0) return Float4{};
      n /= most;
    }
    n = unit(n);
  }
  n[3] = 1;
  return n;
}

inline Record record_of(const vstree::PointSet& points, const Cube& cube, std::uint32_t i) {
  Record record;
  record.position = cube.inside(&points.positions[3 * std::size_t{i}]);
  record.position[3] = std::bit_cast<float>(i);
  record.normal = unit_normal(&points.normals[3 * std::size_t{i}]);
  return record;
}

}  // namespace glark::common
