// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/maps.h>

#include <vector>

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

// Measures the finished maps as a shader reads them: along each edge that two charts share, from both sides, in the first
// `levels` mipmap levels. The levels after the first one have the means of four texels.
std::vector<SeamJumps> check_seams(const Surface& surface, const std::vector<Chart>& charts, const Baked& model,
                                   unsigned levels);

}  // namespace glark::maps
