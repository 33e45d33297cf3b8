// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/level_builder.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "glark/clients/surfel/cull/nodes.h"
#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/stitch/agreement.h"
#include "glark/clients/surfel/stitch/stitcher.h"
#include "glark/clients/surfel/strip/leaf_strips.h"
#include "glark/clients/surfel/triangulate/candidates.h"

namespace glark::surfel {
namespace {

// Divides the surfels into groups of at most five neighbours and keeps the most central surfel of each.
void keep_central_surfels(std::span<Surfel> surfels, std::vector<Surfel>& kept) {
  constexpr std::size_t group_size = 5;
  if (surfels.size() > group_size) {
    Box box;
    for (const Surfel& surfel : surfels) box.add(surfel.position);
    const std::size_t axis = box.widest_axis();
    const std::size_t half = surfels.size() / 2;
    std::nth_element(surfels.begin(), surfels.begin() + static_cast<std::ptrdiff_t>(half), surfels.end(),
                     [axis](const Surfel& a, const Surfel& b) {
                       return std::pair(a.position[axis], a.index) < std::pair(b.position[axis], b.index);
                     });
    keep_central_surfels(surfels.first(half), kept);
    keep_central_surfels(surfels.subspan(half), kept);
    return;
  }
  Vector mean;
  for (const Surfel& surfel : surfels) mean = mean + surfel.position * (1 / static_cast<float>(surfels.size()));
  const auto distance = [&](const Surfel& surfel) { return std::pair(length(surfel.position - mean), surfel.index); };
  kept.push_back(*std::min_element(surfels.begin(), surfels.end(),
                                   [&](const Surfel& a, const Surfel& b) { return distance(a) < distance(b); }));
}

}  // namespace

Level build_level(std::vector<Surfel> surfels, std::vector<std::uint32_t> cloud_indices, const LevelOptions& options,
                  const common::Workers& workers, std::vector<std::uint32_t>& indices) {
  Level level;
  level.cloud_indices = std::move(cloud_indices);
  const std::size_t count = surfels.size();
  level.tree = build_tree(std::move(surfels), options.tree, workers);
  level.owner.resize(count);
  level.place.resize(count);
  level.positions.resize(count);
  level.region_of.resize(count, none);
  level.patches.resize(level.tree.leaves.size());
  level.initial_leaves = level.tree.leaves.size();
  std::vector<std::uint32_t> leaves(level.tree.leaves.size());
  std::iota(leaves.begin(), leaves.end(), 0U);
  workers.in_pieces(leaves.size(), 4 * leaves_a_batch, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) level.register_points(static_cast<std::uint32_t>(leaf));
  });
  make_candidates(level, leaves, options, workers);
  classify_candidates(level, leaves, options, workers);
  stitch(level, leaves, options, workers);
  std::vector<Range> changed;
  make_strips(level, leaves, options, workers, indices, changed);
  level.nodes.resize(level.tree.nodes.size());
  for (auto node = static_cast<std::uint32_t>(level.nodes.size()); node-- > 0;) update_node(level, node, options);
  return level;
}

std::vector<Surfel> coarser_surfels(const Level& level, std::vector<std::uint32_t>& cloud_indices) {
  std::vector<Surfel> kept;
  std::vector<Surfel> own;
  for (const Leaf& leaf : level.tree.leaves) {
    const auto unique = level.tree.unique_surfels(leaf);
    if (unique.empty()) continue;
    own.assign(unique.begin(), unique.end());
    keep_central_surfels(own, kept);
  }
  std::sort(kept.begin(), kept.end(), [](const Surfel& a, const Surfel& b) { return a.index < b.index; });
  cloud_indices.clear();
  for (Surfel& surfel : kept) {
    cloud_indices.push_back(level.cloud_index(surfel.index));
    surfel.index = static_cast<std::uint32_t>(cloud_indices.size() - 1);
  }
  return kept;
}

bool needs_rebuild(const Level& level, const LevelOptions& options) {
  const std::size_t full_leaves = level.owner.size() / options.tree.leaf_points;
  constexpr std::size_t tolerated = 64;
  return level.tree.leaves.size() > 2 * level.initial_leaves + 4 * full_leaves + tolerated;
}

void rebuild_level(Level& level, const LevelOptions& options, const common::Workers& workers,
                   std::vector<std::uint32_t>& indices) {
  std::vector<Surfel> surfels(level.owner.size());
  for (std::uint32_t point = 0; point < surfels.size(); ++point) surfels[point] = level.surfel(point);
  level = build_level(std::move(surfels), std::move(level.cloud_indices), options, workers, indices);
}

}  // namespace glark::surfel
