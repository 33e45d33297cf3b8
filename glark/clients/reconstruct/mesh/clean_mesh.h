// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Removes from the coarse mesh what the samples do not support, and closes its small holes.
#pragma once

#include "glark/clients/reconstruct/mesh/base_mesh.h"

namespace glark::reconstruct {

// Gives each sheet of triangles that touches another one vertices of its own, a little closer to its own triangles.
void separate_sheets(BaseMesh& mesh);

// The others return whether they changed the triangles; mesh.opposite is out of date then.

// Removes triangles that have a vertex far from all samples, from the boundary inwards: there the planes only continue beyond the last
// samples. Such triangles within the surface close a gap and stay. Also removed are the surface between two sheets that face the same
// way, and triangles that hang on by one edge.
bool peel(BaseMesh& mesh);
// Fills holes of at most so many edges with a fan of triangles.
bool close_gaps(BaseMesh& mesh, std::uint32_t most_edges);
// Removes parts with less than this share of the area, and vertices without triangles.
bool drop_parts(BaseMesh& mesh, float least_part);

}  // namespace glark::reconstruct
