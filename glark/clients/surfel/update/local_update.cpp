// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/update/local_update.h"

#include <algorithm>
#include <functional>

#include "glark/clients/surfel/cull/nodes.h"
#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/stitch/agreement.h"
#include "glark/clients/surfel/stitch/stitcher.h"
#include "glark/clients/surfel/strip/leaf_strips.h"
#include "glark/clients/surfel/triangulate/candidates.h"
#include "glark/clients/surfel/triangulate/leaf_inflation.h"
#include "glark/clients/surfel/update/index_set.h"
#include "glark/clients/surfel/update/point_mover.h"

namespace glark::surfel {
namespace {

// Stitched triangles may have points that their leaf did not take in. If such a point moved, the leaf's bounds must
// change, too.
void mark_stitched_points(Patch& patch, std::span<const Surfel> moved) {
  const auto has_moved = [&](std::uint32_t point) {
    const auto found = std::lower_bound(moved.begin(), moved.end(), point,
                                        [](const Surfel& surfel, std::uint32_t index) { return surfel.index < index; });
    return found != moved.end() && found->index == point;
  };
  patch.points_moved = patch.points_moved || std::ranges::any_of(patch.stitched, [&](const StitchedTriangle& stitched) {
                         return std::ranges::any_of(stitched.triangle, has_moved);
                       });
}

// Updates the nodes of the leaves and all their ancestors.
void update_nodes(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options) {
  level.nodes.resize(level.tree.nodes.size());
  IndexSet nodes;
  for (const std::uint32_t leaf : leaves) {
    std::uint32_t node = level.tree.leaves[leaf].node;
    for (; node != none && !nodes.has(node); node = level.tree.nodes[node].parent) nodes.add(node);
  }
  std::sort(nodes.list().begin(), nodes.list().end(), std::greater<>());  // children have higher numbers
  for (const std::uint32_t node : nodes.list()) update_node(level, node, options);
}

}  // namespace

void update_level(Level& level, std::span<const Surfel> moved, const LevelOptions& options,
                  const common::Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed) {
  const std::vector<std::uint32_t> triangulated = PointMover(level, moved, options).run();
  make_candidates(level, triangulated, options, workers);
  // Neighbours may share triangles with these leaves. Other leaves may share conflict regions.
  IndexSet drawn;
  std::vector<std::uint32_t> neighbours;
  for (const std::uint32_t leaf : triangulated) {
    drawn.add(leaf);
    find_neighbours(level.tree, leaf, neighbours);
    for (const std::uint32_t neighbour : neighbours) drawn.add(neighbour);
  }
  classify_candidates(level, drawn.list(), options, workers);
  for (const std::uint32_t leaf : stitch(level, drawn.list(), options, workers)) drawn.add(leaf);
  for (const std::uint32_t leaf : drawn.list()) mark_stitched_points(level.patches[leaf], moved);
  make_strips(level, drawn.list(), options, workers, indices, changed);
  update_nodes(level, drawn.list(), options);
}

void compact_level(Level& level) {
  compact_slots(level.candidates, [&](const auto& body) {
    for (Patch& patch : level.patches) body(patch.candidates);
  });
  const bool moved = compact_slots(level.tree.surfels, [&](const auto& body) {
    for (Leaf& leaf : level.tree.leaves) body(leaf.surfels);
  });
  if (!moved) return;
  for (std::uint32_t leaf = 0; leaf < level.tree.leaves.size(); ++leaf) level.register_points(leaf);
}

}  // namespace glark::surfel
