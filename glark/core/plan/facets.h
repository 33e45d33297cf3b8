// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/state/environment.h"
#include "glark/core/state/programs/program.h"

namespace glark::core {

// Whether, with --refine smooth, the normal of one corner decides how a whole triangle looks, or the fragments compute one
// normal for the triangle. Then each triangle is meant to be seen, and normals may be those of triangles.
bool shows_facets(const Environment& environment, const Program& program);

}  // namespace glark::core
