// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Assembles the model: the mesh with the texture coordinates of its charts, and the maps of all charts.
#pragma once

#include <glark/maps.h>

#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/maps/project/chart_map.h"
#include "glark/clients/maps/project/whole_map.h"

namespace glark::maps {

// The finished maps of the charts, with their places.
struct Charts {
  const Surface& surface;
  const std::vector<Chart>& charts;
  const Atlas& atlas;
  const std::vector<ChartMap>& maps;
  unsigned channels = 0;
};

// Sets the mesh and the maps of `model`.
void assemble(const Charts& charts, const common::Workers& workers, Baked& model);

// The same for islands of the mesh's own texture coordinates: vertices stay in their order. Where one has several tangents,
// as at the border of a mirrored island, the others are added at the end.
void assemble(const Surface& surface, std::span<const float> texcoords, const std::vector<Chart>& islands,
              const WholeMap& whole, unsigned channels, Baked& model);

}  // namespace glark::maps
