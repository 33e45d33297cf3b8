// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Updates a level where points moved: only the leaves around them are processed again.
// Based on: Boubekeur 2007, ch. 5.2.7.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// moved: points of the level at their new positions, in ascending order of their indices, without duplicates. Indices
// beyond the level's points are new points, without gaps. Ranges of `indices` that changed are appended to `changed`.
void update_level(Level& level, std::span<const Surfel> moved, const LevelOptions& options,
                  const common::Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed);

// Closes the gaps in the level's arrays where more than half of an array is unused.
void compact_level(Level& level);

}  // namespace glark::surfel
