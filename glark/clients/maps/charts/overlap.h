// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds triangles of a chart that cover each other in its plane, or that face away from it, and cuts the chart there.
#pragma once

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

// Returns a chart with the triangles that were cut off; without triangles if nothing overlaps. The chart that is left
// has at least one triangle. Each call cuts off at least one.
Chart cut_overlap(Chart& chart, const Surface& surface);

}  // namespace glark::maps
