// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/geometry/geometry.h"

namespace glark::geometry {

// Returns the area of all triangles, in the square of the positions' unit.
double area_of(const Geometry& mesh);

}  // namespace glark::geometry
