// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "glark/clients/maps/project/chart_map.h"
#include "glark/clients/maps/project/whole_map.h"

namespace glark::maps {

// Makes the maps of two charts agree along the edges that they share. Normals next to these edges may have another
// length than 1 afterwards. At hard edges, the normals of both sides stay as they are; edges where they hardly differ become
// soft.
void equalise_seams(Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas, unsigned channels,
                    std::vector<ChartMap>& maps);

// The same for islands of the mesh's own texture coordinates, whose maps are joined.
void equalise_seams(Surface& surface, const std::vector<Chart>& islands, const Atlas& atlas, unsigned channels,
                    WholeMap& whole);

// Gives charts without points the colours of their neighbours, from the edges that they share into their middle.
// is_empty: [charts]. Charts that touch no chart with points stay empty.
void spread_colours(const Surface& surface, const std::vector<Chart>& charts, const Atlas& atlas,
                    std::vector<ChartMap>& maps, std::vector<bool>& is_empty);

}  // namespace glark::maps
