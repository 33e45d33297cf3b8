// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Builds stripping trees and rebuilds single leaves.
// Based on: Boubekeur 2007, ch. 5.2.4. The thesis splits nodes into eight. We split them in two at the median, so
// leaves are fuller. Fuller leaves share fewer points with their neighbours.
#pragma once

#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/tree/height_field.h"
#include "glark/clients/surfel/tree/stripping_tree.h"

namespace glark::surfel {

struct TreeOptions {
  unsigned leaf_points;            // the most points in one leaf
  HeightFieldLimits height_field;  // leaves that exceed these limits are split
  float inflation;                 // the inflation radius of a leaf, in mean spacings of its points
};

// Consumes the surfels and reorders them.
StrippingTree build_tree(std::vector<Surfel> surfels, const TreeOptions& options, const common::Workers& workers);

// Builds a subtree over `surfels`, a range of tree.surfels that is reordered in place. The subtree replaces the leaf
// `node`. The first leaf of the subtree keeps the number of the old leaf. Further leaves and nodes are appended.
void rebuild_leaf(StrippingTree& tree, std::uint32_t node, Slot surfels, const TreeOptions& options);

}  // namespace glark::surfel
