// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The public nodes of a level, with bounding boxes and normal cones for culling.
#pragma once

#include <cstdint>

#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Computes the element of Level::nodes for a node, from its leaf or its children.
void update_node(Level& level, std::uint32_t node, const LevelOptions& options);

}  // namespace glark::surfel
