// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edges that connect the same two vertices as another edge. They appear where a thin sheet has one vertex for both of
// its sides, at its rim.
#pragma once

#include "glark/clients/reconstruct/mesh/base_mesh.h"

namespace glark::reconstruct {

// Inserts vertices into edges of more than two triangles, so that each edge has at most two. Returns whether there were
// such edges.
bool divide_repeated_edges(BaseMesh& mesh);

}  // namespace glark::reconstruct
