// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Decides which edges may be flipped to save indices.
#pragma once

#include "glark/clients/surfel/tree/vector.h"

namespace glark::surfel {

inline constexpr float least_flat_cosine = 0.9F;  // the angle's cosine between the normals of two flat triangles

// Returns whether the triangles p, a, b and d, b, a may become p, a, d and p, d, b. All four must be flat, and the
// angles opposite to the new edge must not be too obtuse.
bool may_flip_edge(Vector p, Vector a, Vector d, Vector b);

}  // namespace glark::surfel
