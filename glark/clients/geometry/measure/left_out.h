// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Counts the points that a mesh of them leaves out.
#pragma once

#include <cstddef>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Returns the number of points that are far from the mesh. Points within `distance` of it never count. Points beyond
// six times this distance always count, unless that is less than a 500th of the greatest extent of the points. The
// distance is above 0. Both geometries have the same origin.
std::size_t points_left_out(const Geometry& points, const Geometry& mesh, double distance);

}  // namespace glark::geometry
