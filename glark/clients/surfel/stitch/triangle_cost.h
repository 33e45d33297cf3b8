// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Returns the normal of a point, or the normal of its leaf's plane if the point has none.
Vector point_normal(const Level& level, std::uint32_t point);

// Returns the squared radius of the circumcircle. The cost is higher if the triangle's plane does not fit the normals
// of its points. It is negative for back-facing triangles.
float triangle_cost(const Level& level, const Triangle& triangle);

}  // namespace glark::surfel
