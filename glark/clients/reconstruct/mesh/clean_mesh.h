// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Removes parts of the coarse mesh that the samples do not support, and closes small holes.
#pragma once

#include "glark/clients/reconstruct/mesh/base_mesh.h"

namespace glark::reconstruct {

// Where sheets of triangles touch, gives each sheet its own vertices, a little closer to its own triangles.
void separate_sheets(BaseMesh& mesh);

// The functions below return whether they changed the triangles. If so, mesh.opposite is out of date.

// Removes triangles that have a vertex far from all samples, from the boundary inwards. There the planes only continue
// beyond the last samples. Such triangles inside the surface close a gap and stay.
// Also removes the surface between two sheets that face the same way, and triangles that hang on by one edge.
bool peel(BaseMesh& mesh);
// Fills each hole of at most `most_edges` edges with a fan of triangles.
bool close_gaps(BaseMesh& mesh, std::uint32_t most_edges);
// Removes parts with less than `least_part` of the area, and vertices without triangles.
bool drop_parts(BaseMesh& mesh, float least_part);

}  // namespace glark::reconstruct
