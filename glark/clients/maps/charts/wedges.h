// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

// Sets the wedges of a chart and their tangents. The triangles are in order, and the frame is set.
void set_wedges(Chart& chart, const Surface& surface);

}  // namespace glark::maps
