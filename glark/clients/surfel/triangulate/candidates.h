// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Triangulates the leaves and fills in their candidates and the spacings of their points.
void make_candidates(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                     const common::Workers& workers);

}  // namespace glark::surfel
