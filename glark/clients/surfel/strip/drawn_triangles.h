// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Decides which triangles of a leaf's patch are drawn. The result does not depend on the order in which leaves are
// processed.
// Based on: Boubekeur 2007, ch. 5.2.2: outer, redundant, dual and valid triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Lists the valid triangles of a leaf and fills in the counts of the patch.
void collect_drawn_triangles(const Level& level, std::uint32_t leaf, Patch& patch, std::vector<Triangle>& valid);

}  // namespace glark::surfel
