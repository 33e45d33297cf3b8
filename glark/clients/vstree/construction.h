// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The recursive construction of a volume-surface tree, several levels at a time.
#pragma once

#include <glark/vstree.h>

#include <vector>

#include "glark/clients/vstree/local_frame.h"
#include "glark/clients/workers.h"

namespace glark::vstree {

struct Nodes {
  std::vector<Node> nodes;
  std::vector<LocalFrame> frames;
  std::vector<std::uint32_t> frame_nodes;  // of each frame its transition node
};

// The tree of points within the cube, with their normals (of unit length, the fourth 1, or zero); `order` gets the samples in the
// tree's order.
Nodes construct(std::span<const Float4> points, std::span<const Float4> normals, const Options& options, float diagonal,
                std::vector<std::uint32_t>& order, const Workers& workers);
// The same of points as a caller has them, checked and with normals.
Nodes construct(const PointSet& points, const Cube& cube, const Options& options, std::vector<std::uint32_t>& order,
                const Workers& workers);

}  // namespace glark::vstree
