// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// The normal of a point, or that of its leaf's plane where the point has none.
Vector point_normal(const Level& level, std::uint32_t point);

// The squared radius of the circumcircle; more where the triangle's plane and the normals of its points differ.
// Negative for back-facing triangles.
float triangle_cost(const Level& level, const Triangle& triangle);

}  // namespace glark::surfel
