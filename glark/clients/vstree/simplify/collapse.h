// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Simplification by edge collapses. The vertices of the result are vertices of the input.
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// Meshes with fewer triangles than this are collapsed by Method::automatic.
constexpr std::size_t least_to_cluster = 200000;

// Returns the method that Method::automatic begins with.
Method method_for(const Mesh& mesh, const SimplifyOptions& options);

// Whether this build has collapses, and the options a goal for them.
bool can_collapse(const Mesh& mesh, const SimplifyOptions& options);

// Collapses edges with meshoptimizer. Points at one position with equal colours and texture coordinates are one vertex.
// Such a vertex may have points with different normals. A corner of the result then has the point whose normal is nearest
// to that of its triangle, so hard edges keep their two normals. Error: Element::option if this build has no meshoptimizer.
Simplified collapse(const Surface& surface, const SimplifyOptions& options);

}  // namespace glark::vstree
