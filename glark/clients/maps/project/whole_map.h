// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The maps of all islands of the mesh's own texture coordinates in one map, as they lie in the texture. Islands may be so
// near to each other that bilinear filtering reads texels of both. So seams are made equal here.
#pragma once

#include <vector>

#include "glark/clients/maps/project/chart_map.h"

namespace glark::maps {

struct WholeMap {
  ChartMap map;                       // the first row is the lowest one; the weights are 1 where a texel has an owner
  std::vector<std::uint32_t> owners;  // the island that gives each texel; or none: it is far from all
};

// The owner of a texel is the island that covers its centre, or else the nearest one, up to the gutter. Texels without an
// owner are flat, and have the colours of those around them: they matter in small mipmap levels. Takes the memory of `maps`.
WholeMap join_maps(const std::vector<Chart>& islands, const Surface& surface, const Atlas& atlas, unsigned channels,
                   std::vector<ChartMap>& maps);

// The lowest row of a place, counted from below.
inline unsigned bottom_of(const Place& place, const Atlas& atlas) { return atlas.height - place.y - place.height; }

}  // namespace glark::maps
