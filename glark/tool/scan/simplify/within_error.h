// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Simplification to a distance that is measured. The estimate of an edge collapse may be several times too small.
#pragma once

#include <glark/vstree.h>

#include "glark/tool/scan/simplified.h"

namespace glark::tool {

// Collapses the mesh several times, with other bounds of the estimate. Returns the result with the fewest triangles among
// those whose Hausdorff distance from the mesh is at most options.max_error, or else the whole mesh. The distance is
// that of geometry::distance_between(), at its samples; Coarse has it. The target stops collapses earlier. The mesh has triangles.
Coarse simplified_within_error(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options);

}  // namespace glark::tool
