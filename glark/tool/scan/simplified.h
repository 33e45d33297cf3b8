// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/vstree.h>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

struct Coarse {
  geometry::Geometry geometry;
  vstree::Method method;
  float error;  // of a collapse, relative to the diagonal
};

// The same geometry with fewer triangles, or points. Throws what vstree::simplify() throws.
Coarse simplified(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options);

}  // namespace glark::tool
