// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Divides the coarse mesh into charts: the transition nodes of a volume-surface tree over its triangles. A chart is
// connected, and its triangles do not overlap in the chart's plane.
// Source: Boubekeur 2007, ch. 3.2 and 6.2.3.
#pragma once

#include <vector>

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

// cut: no chart reaches across a hard edge, except around its end.
std::vector<Chart> segment(const Surface& surface, bool cut = true);

}  // namespace glark::maps
