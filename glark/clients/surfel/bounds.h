// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Boxes and cones of normals, for culling.
#pragma once

#include <span>

#include "glark/clients/surfel/layer.h"
#include "glark/clients/surfel/strip_path.h"

namespace glark::surfel {

// Of the triangles that are drawn: their normals, not those of the points, say what a viewer sees.
void bound(const Layer& layer, std::span<const StripTriangle> triangles, Patch& patch);

}  // namespace glark::surfel
