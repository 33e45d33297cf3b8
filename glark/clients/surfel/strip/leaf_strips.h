// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Makes the strips of the leaves and their bounds. A strip that no longer fits into its slot moves to the end of
// `indices`. The ranges of `indices` that changed are appended to `changed`.
void make_strips(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                 const common::Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed);

}  // namespace glark::surfel
