// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals of the points of a mesh, from its triangles.
#pragma once

#include <vector>

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Returns 3 numbers per point: the mean of the normals of its triangles, weighted by area. It has unit length, or is
// zero if the point has no triangle with an area.
std::vector<float> triangle_normals(const Geometry& mesh);

}  // namespace glark::geometry
