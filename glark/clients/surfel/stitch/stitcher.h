// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Stitches the triangulations of neighbouring leaves where they conflict. The triangles on which all leaves agree form
// a surface: around each point, they belong to one triangulation. The stitcher finds the conflict regions between these
// triangles and fills each region with triangles.
// Based on: Boubekeur 2007, ch. 5.2.2. The thesis resolves dual pairs, two triangles at a time. We stitch whole
// regions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Stitches the conflict regions at `leaves`, whose candidates were classified again. Fills in Patch::stitched of these
// leaves, and of all other leaves at the same regions. Returns all these leaves, ascending.
std::vector<std::uint32_t> stitch(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                                  const common::Workers& workers);

}  // namespace glark::surfel
