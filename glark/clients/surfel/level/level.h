// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One level of detail: a stripping tree, the candidate triangles of its leaves, and the strips of these triangles. Each
// stage fills in its part.
#pragma once

#include <glark/surfel.h>

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/level/candidate.h"
#include "glark/clients/surfel/tree/stripping_tree.h"
#include "glark/clients/surfel/tree/tree_builder.h"

namespace glark::surfel {

// A triangle that is drawn in a conflict region, where leaves disagree.
struct StitchedTriangle {
  Triangle triangle;
  std::uint32_t region;
};

// Numbers of triangles and edges of a leaf, see glark::surfel::Counts.
struct PatchCounts {
  std::size_t outer = 0, redundant = 0, dual = 0, valid = 0, out_of_reach = 0;
  std::size_t flipped_in_triangulation = 0, flipped_in_strip = 0;
};

// The bounding box and the normal cone of drawn triangles.
struct Bounds {
  Box box;
  Vector cone_axis, cone_apex;
  float cone_cosine = -2;  // the cosine of the cone's half-angle
};

// The triangles and the strip of one leaf.
struct Patch {
  Slot candidates;  // a range of Level::candidates
  // The number of candidates with points of other leaves; they come first, in ascending order.
  std::uint32_t shared_count = 0;
  std::vector<StitchedTriangle> stitched;  // empty for most leaves
  Slot strip;                              // a range of the indices of all strips
  std::uint64_t drawn_hash = 0;            // a hash of the triangles in the strip
  bool points_moved = true;                // since the strip, the box and the cone were made
  PatchCounts counts;
  Bounds bounds;  // of the drawn triangles
};

struct LevelOptions {
  TreeOptions tree;
  float reach;
  float unit;  // the length of one unit of the surfels' coordinates, in the caller's units
  bool has_normals;
  bool flip_edges;
};

// Points are numbered within the level.
struct Level {
  StrippingTree tree;
  std::vector<Patch> patches;  // one for each leaf of the tree
  std::vector<Candidate> candidates;
  std::vector<Node> nodes;           // one for each node of the tree, in the caller's units
  std::vector<std::uint32_t> owner;  // the leaf of each point
  std::vector<std::uint32_t> place;  // the index of each point in tree.surfels
  std::vector<Vector> positions;     // for each point
  // The index of each point in the cloud. Empty if the level has all points of the cloud.
  std::vector<std::uint32_t> cloud_indices;
  std::size_t initial_leaves = 0;  // the number of leaves when the tree was built

  // A conflict region is a set of points. Its lowest point names it. For each point, this is the region, or `none`, as
  // for most points.
  std::vector<std::uint32_t> region_of;
  // Links the points of each region to a ring: the next point of each point. Empty until there is a region.
  std::vector<std::uint32_t> next_in_region;

  const Surfel& surfel(std::uint32_t point) const { return tree.surfels[place[point]]; }
  std::span<const Candidate> candidates_of(std::uint32_t leaf) const {
    return {candidates.data() + patches[leaf].candidates.first, patches[leaf].candidates.count};
  }
  std::uint32_t cloud_index(std::uint32_t point) const { return cloud_indices.empty() ? point : cloud_indices[point]; }

  // Updates owner, place and position of the points of a leaf.
  void register_points(std::uint32_t leaf) {
    const Slot& slot = tree.leaves[leaf].surfels;
    for (std::uint32_t i = slot.first; i < slot.first + slot.count; ++i) {
      owner[tree.surfels[i].index] = leaf;
      place[tree.surfels[i].index] = i;
      positions[tree.surfels[i].index] = tree.surfels[i].position;
    }
  }
};

// Returns a capacity that is enough for the candidates or indices of most clouds.
inline std::size_t usual_capacity(const Level& level, std::span<const std::uint32_t> leaves) {
  std::size_t points = 0;
  for (const std::uint32_t leaf : leaves) points += level.tree.leaves[leaf].unique_count;
  return 3 * points;
}

}  // namespace glark::surfel
