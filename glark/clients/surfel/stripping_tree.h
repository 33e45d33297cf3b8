// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The stripping tree: a hierarchy of boxes about the points, whose leaves are small height fields.
// Based on: Boubekeur 2007, ch. 5.2.4. Nodes are halved at their median instead of split in eight, so that leaves are full:
// the fuller they are, the less of the work goes into the points that they share.
#pragma once

#include <glark/surfel.h>

#include <cstdint>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/surfel/vector.h"

namespace glark::surfel {

using common::Workers;

// A point of the cloud.
struct Surfel {
  Vector position;
  std::uint32_t index = none;
  Vector normal;      // of unit length, or zero
  float spacing = 0;  // the distance to neighbours, which triangulate() finds
};

// A piece of a larger array, with room to grow in.
struct Slot {
  std::uint32_t first = 0, count = 0, capacity = 0;
};

struct Leaf {
  std::uint32_t node = none;
  Slot surfels;
  std::uint32_t used = 0;  // of the surfels, those that come first: the others are at the same places
  float band = 0;          // how far it takes in points of others
  Vector normal;           // of its plane, of unit length
  Vector centre;
};

struct TreeNode {
  Box box;
  float band = 0;  // greatest of the leaves below
  std::uint32_t parent = none;
  std::uint32_t left = none, right = none;
  std::uint32_t leaf = none;  // none: an inner node
  Vector mean;                // of the points below
  std::uint32_t used = 0;     // points below
  std::uint32_t representative = none;
  Vector representative_position;
};

struct StrippingTree {
  std::vector<Surfel> surfels;  // leaf by leaf
  std::vector<Leaf> leaves;
  std::vector<TreeNode> nodes;  // the root is the first

  // The leaf's points that are drawn.
  std::span<Surfel> used(const Leaf& leaf) { return {surfels.data() + leaf.surfels.first, leaf.used}; }
  std::span<const Surfel> used(const Leaf& leaf) const { return {surfels.data() + leaf.surfels.first, leaf.used}; }
};

struct TreeOptions {
  unsigned leaf_points;
  float delta_a, delta_d;
  float inflation;
};

// Takes the surfels over; reorders them.
StrippingTree build_tree(std::vector<Surfel> surfels, const TreeOptions& options, const Workers& workers);

// Splits surfels into the leaves of a subtree, which takes the place of `node`, a leaf. They stay where they
// are in tree.surfels, reordered. Its leaf becomes the first of theirs; the others are new.
void plant(StrippingTree& tree, std::uint32_t node, Slot surfels, const TreeOptions& options);

// Box, mean and representative of a node from its children, or from the points of its leaf.
void refit(StrippingTree& tree, std::uint32_t node);

}  // namespace glark::surfel
