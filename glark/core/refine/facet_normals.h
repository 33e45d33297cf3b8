// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace glark::refine {

// Whether fragments compute the normal of their triangle: the cross product of two derivatives, by x and y. Bump maps
// multiply a derivative and a normal instead.
bool computes_facet_normals(const std::vector<std::string>& fragment_sources);

}  // namespace glark::refine
