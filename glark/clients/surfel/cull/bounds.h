// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Computes bounding boxes and normal cones of triangles.
// Based on: meshopt_computeClusterBounds of meshoptimizer (Kapoulkine).
#pragma once

#include <span>

#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

inline constexpr float cone_margin = 1e-3F;  // in radians; rounding requires cones that are wider by this

// triangles: the drawn ones. A viewer sees the normals of the triangles, not the normals of the points.
Bounds compute_bounds(const Level& level, std::span<const Triangle> triangles);

}  // namespace glark::surfel
