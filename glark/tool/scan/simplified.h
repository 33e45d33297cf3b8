// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/vstree.h>

#include <optional>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

struct Coarse {
  geometry::Geometry geometry;
  vstree::Method method;
  float error;                     // of a collapse, an estimate relative to the diagonal
  std::optional<double> measured;  // the Hausdorff distance, relative to the diagonal
};

// The same geometry with fewer triangles, or points. Throws what vstree::simplify() throws.
Coarse simplified(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options);

}  // namespace glark::tool
