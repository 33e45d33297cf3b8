// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One level of detail: a stripping tree, the candidates of its leaves, and the strips that are made of them.
#pragma once

#include <glark/surfel.h>

#include <cstdint>
#include <vector>

#include "glark/clients/surfel/patch.h"
#include "glark/clients/surfel/strip_path.h"
#include "glark/clients/surfel/stripping_tree.h"

namespace glark::surfel {

// What is drawn where leaves disagree.
struct MendedTriangle {
  StripTriangle triangle;
  std::uint32_t rift;
};

// What is known of a leaf's patch.
struct Patch {
  Slot candidates;
  std::uint32_t shared = 0;  // of the candidates, those that other leaves could have: they come first, ascending
  Slot strip;
  std::size_t outer = 0, redundant = 0, dual = 0, valid = 0, out_of_reach = 0;
  std::uint64_t drawn = 0;             // a fingerprint of its triangles
  std::size_t evened = 0, turned = 0;  // edges, in the triangulation and in the strip
  std::vector<MendedTriangle> mended;  // few leaves have any
  Box box;                             // of what is drawn
  Vector cone_axis, cone_apex;
  float cone_cosine = -2;  // 2: nothing is drawn
  bool moved = true;       // since box and cone were found
};

struct Layer {
  StrippingTree tree;
  std::vector<Patch> patches;  // of the tree's leaves
  std::vector<Candidate> candidates;
  std::vector<Node> nodes;           // of the tree's nodes, in the caller's units
  std::vector<std::uint32_t> owner;  // of points: their leaf
  std::vector<std::uint32_t> place;  // of points: where in tree.surfels
  std::vector<Vector> positions;     // of points
  std::vector<std::uint32_t>
      names;  // of points: their number in the cloud; empty: they are all the points of the cloud

  std::size_t planted = 0;  // leaves, when the tree was built
  // Places of disagreement, which have their lowest point's number; of points that have triangles there: that number, and the next of
  // these points, in a ring.
  std::vector<std::uint32_t> rift_of;       // `none` for most
  std::vector<std::uint32_t> next_in_rift;  // empty before there is a rift

  const Surfel& surfel(std::uint32_t point) const { return tree.surfels[place[point]]; }
  std::span<const Candidate> candidates_of(std::uint32_t leaf) const {
    return {candidates.data() + patches[leaf].candidates.first, patches[leaf].candidates.count};
  }
  std::uint32_t name(std::uint32_t point) const { return names.empty() ? point : names[point]; }
  void find_owners(std::uint32_t leaf) {
    const Slot& slot = tree.leaves[leaf].surfels;
    for (std::uint32_t i = slot.first; i < slot.first + slot.count; ++i) {
      owner[tree.surfels[i].index] = leaf;
      place[tree.surfels[i].index] = i;
      positions[tree.surfels[i].index] = tree.surfels[i].position;
    }
  }
};

struct LayerOptions {
  TreeOptions tree;
  float reach;
  float unit;     // the caller's, in that of the surfels
  bool oriented;  // points have normals
  bool turn_edges;
};

// Takes the surfels over. The strips are appended to `indices`.
Layer build_layer(std::vector<Surfel> surfels, std::vector<std::uint32_t> names, const LayerOptions& options,
                  const Workers& workers, std::vector<std::uint32_t>& indices);

// Candidates, then what others say of them, then strips, of leaves that are named; strips that grow move to the end of `indices`. Appends what changed there.
void make_candidates(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                     const Workers& workers);
void agree_on_candidates(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                         const Workers& workers);
void make_strips(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                 const Workers& workers, std::vector<std::uint32_t>& indices, std::vector<Range>& changed);

// The public node of a node, from its leaf or its children.
void describe(Layer& layer, std::uint32_t node, const LayerOptions& options);

// A quarter of the points or so: of every few neighbours, the one in their middle.
std::vector<Surfel> coarser(const Layer& layer, std::vector<std::uint32_t>& names);

}  // namespace glark::surfel
