// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The surface where the partition of unity of the transition layer's planes is zero.
#pragma once

#include "glark/clients/reconstruct/contour/transition_layer.h"

namespace glark::reconstruct {

// The surface has a vertex for each of its sheets in a cell, and a quadrilateral for each edge of the grid that it
// crosses.
struct Contour {
  std::vector<Float4> points;
  std::vector<std::uint64_t> cells;  // [points], the keys of the cells on the grid's level
  std::vector<std::uint32_t> quads;  // [4 * quads], counter-clockwise seen from outside
  bool has_thin_cells = false;
};

// Contours the layer on the grid of the level.
Contour contour(const TransitionLayer& layer, unsigned level, const Workers& workers);

}  // namespace glark::reconstruct
