// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The transition layer of the octree: cells whose samples are a height field, with the planes of their samples.
#pragma once

#include "glark/clients/common/points/moments.h"
#include "glark/clients/reconstruct/samples/octree.h"

namespace glark::reconstruct {

// The mean plane of the samples of a cell. A cell of the finest level has two planes if its samples are no height
// field: one for each side of a thin sheet.
struct SupportPlane {
  Float4 point;       // the centroid; the fourth is the radius of the ball in which the plane counts
  Float4 normal;      // the fourth is the weight of the plane
  std::uint64_t key;  // the key of the cell
  unsigned level;
};

struct TransitionLayer {
  std::vector<SupportPlane> planes;
  // The cells of the transition nodes of each level, the finest first: the first plane of each. A cell's planes follow
  // one another.
  std::vector<CellTable> cells;
};

TransitionLayer transition_layer(const Octree& octree, const ReconstructOptions& options, const Workers& workers);

}  // namespace glark::reconstruct
