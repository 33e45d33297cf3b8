// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/vstree/simplify/clusters.h"

namespace glark::vstree {

// Returns whether clusters did not suit the surface. Clusters that are wider than a wall is thick take points of both of
// its sides. Then the wall falls into pieces, large parts become one, or surfaces between parts add area.
bool falls_apart(const Surface& from, const Simplified& result);

// Removes crumbs that were pinched off where sheets touched: parts of few triangles, if more is left of their part of the
// input. Small parts of the input stay.
void drop_pinched_off(const Surface& from, Simplified& result);

void drop_unused_vertices(Simplified& result);

}  // namespace glark::vstree
