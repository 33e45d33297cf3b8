// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The octree's transition layer: cells whose samples are a height field, each with the plane of its samples.
#pragma once

#include "glark/clients/reconstruct/samples/octree.h"
#include "glark/clients/common/points/moments.h"

namespace glark::reconstruct {

// The mean plane of samples of one cell. A cell of the finest level whose samples are no height field has two, for the two sides of a
// thin sheet.
struct SupportPlane {
  Float4 point;       // the centroid; the fourth is the radius of the ball in which the plane counts
  Float4 normal;      // the fourth is its weight
  std::uint64_t key;  // of the cell
  unsigned level;
};

struct TransitionLayer {
  std::vector<SupportPlane> planes;
  std::vector<CellTable> cells;  // by level, the finest first: the transition nodes' cells
};

TransitionLayer transition_layer(const Octree& octree, const ReconstructOptions& options, const Workers& workers);

}  // namespace glark::reconstruct
