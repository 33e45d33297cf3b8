// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/vstree.h>

#include "glark/clients/geometry/geometry.h"

namespace glark::tool {

// The same geometry with fewer triangles, or points. Throws what vstree::simplify() throws.
geometry::Geometry simplified(const geometry::Geometry& geometry, const vstree::SimplifyOptions& options);

}  // namespace glark::tool
