// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The recursive construction of a volume-surface tree, several levels at a time.
#pragma once

#include <glark/vstree.h>

#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/vstree/tree/local_frame.h"

namespace glark::vstree {

struct Nodes {
  std::vector<Node> nodes;
  std::vector<LocalFrame> frames;
  std::vector<std::uint32_t> frame_nodes;  // the transition node of each frame
};

// Builds the tree of checked points with normals. `order` receives the samples in the tree's order. `sorted`, if given,
// receives their records.
// ends_at_layer: transition nodes are leaves. A node does not become a transition node if the metric makes it a leaf.
Nodes construct(const PointSet& points, const Cube& cube, const Options& options, std::vector<std::uint32_t>& order,
                const Workers& workers, Records* sorted = nullptr, bool ends_at_layer = false);

}  // namespace glark::vstree
