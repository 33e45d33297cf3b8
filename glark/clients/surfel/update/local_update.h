// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Updates a level where points moved: it processes only the leaves around these points again.
// Based on: Boubekeur 2007, ch. 5.2.7.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// moved: points of the level at their new positions, in ascending order of their indices, without duplicates. Indices
// beyond the level's points are new points, without gaps. The ranges of `indices` that changed are appended to
// `changed`.
void update_level(Level& level, std::span<const Surfel> moved, const LevelOptions& options,
                  const common::Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed);

// Closes the gaps in the level's arrays. An array changes only if more than half of it is unused.
void compact_level(Level& level);

}  // namespace glark::surfel
