// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares the candidates of neighbouring leaves. Do all leaves that own a corner of a triangle have the triangle?
// Based on: Boubekeur 2007, ch. 5.2.2.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/level/level.h"

namespace glark::surfel {

// Classifies the shared candidates of the leaves: it sets their states.
void classify_candidates(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                         const common::Workers& workers);

Corners sorted_corners(std::uint32_t a, std::uint32_t b, std::uint32_t c);

// Returns the squared length of the longest edge.
float squared_longest_edge(const Level& level, const Corners& corners);

// Returns whether all edges are short enough for the spacings of the corners. The answer does not depend on a leaf. So
// leaves agree on holes.
bool is_in_reach(const Level& level, const Corners& corners, float reach);

// Returns the leaf that draws a triangle: the first of the leaves that own a corner.
inline std::uint32_t drawing_leaf(const Level& level, const Corners& corners) {
  return std::min({level.owner[corners[0]], level.owner[corners[1]], level.owner[corners[2]]});
}

}  // namespace glark::surfel
