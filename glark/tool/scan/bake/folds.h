// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Folded triangles: their normals point away from the normals of their own vertices. Simplification leaves a few. They are
// lit from the wrong side, and no point of the scan lies on them.
#pragma once

#include <cstddef>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// Flips edges of folded triangles where both new triangles face the same side as their vertices, and moves vertices of the
// others towards the middle of their neighbours. Vertices at boundaries stay, and those that share their place with
// others. The mesh has normals.
// Returns the number of folded triangles that are left.
std::size_t unfold(geometry::Geometry& mesh);

}  // namespace glark::tool
