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

// Builds the leaves around the moved points again. moved: points at their new positions, in ascending order of their
// indices, without duplicates. New points have the indices that follow those of the level, without gaps. Appends the
// ranges of `indices` that changed to `changed`.
void update_level(Level& level, std::span<const Surfel> moved, const LevelOptions& options,
                  const common::Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed);

// Closes the gaps in the level's arrays. An array changes only if more than half of it is unused.
void compact_level(Level& level);

}  // namespace glark::surfel
