// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Charts that are the islands of the coarse mesh's own texture coordinates.
#pragma once

#include <string>
#include <vector>

#include "glark/clients/maps/charts/chart.h"

namespace glark::maps {

// Says why maps cannot use the texture coordinates of the mesh. Empty: they can.
std::string fault_of_texcoords(const Surface& surface);

// The parts of the mesh that are connected in the texture, and turn there in one direction.
std::vector<Chart> islands_of(const Surface& surface);

// Returns at most two charts with the triangles of all islands: those that are mirrored, and the others.
std::vector<Chart> join_islands(const std::vector<Chart>& islands, const Surface& surface);

}  // namespace glark::maps
