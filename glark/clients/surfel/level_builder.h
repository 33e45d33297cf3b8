// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds a level of detail: all stages, one after the other.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Consumes the surfels. Appends the strips to `indices`. cloud_indices: see Level.
Level build_level(std::vector<Surfel> surfels, std::vector<std::uint32_t> cloud_indices, const LevelOptions& options,
                  const common::Workers& workers, std::vector<std::uint32_t>& indices);

// Returns about a quarter of the surfels, for the next coarser level. cloud_indices: gets their indices in the cloud.
std::vector<Surfel> coarser_surfels(const Level& level, std::vector<std::uint32_t>& cloud_indices);

// Returns whether updates have left too many leaves, so that the level should be built again.
bool needs_rebuild(const Level& level, const LevelOptions& options);

// Builds the level again from its points. Appends the strips to `indices`.
void rebuild_level(Level& level, const LevelOptions& options, const common::Workers& workers,
                   std::vector<std::uint32_t>& indices);

}  // namespace glark::surfel
