// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The stripping tree: a binary hierarchy of bounding boxes over the points. Each leaf is a small height field.
// Based on: Boubekeur 2007, ch. 5.2.4.
#pragma once

#include <glark/surfel.h>

#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/tree/box.h"
#include "glark/clients/surfel/tree/vector.h"

namespace glark::surfel {

// A point of the cloud.
struct Surfel {
  Vector position;
  std::uint32_t index = none;
  Vector normal;      // unit length, or zero where it is not known
  float spacing = 0;  // the distance to the neighbours, computed by the triangulation of the point's leaf
};

// A range of a larger array, with room to grow.
struct Slot {
  std::uint32_t first = 0, count = 0, capacity = 0;
};

struct Leaf {
  std::uint32_t node = none;
  Slot surfels;                    // distinct positions first, then the duplicates
  std::uint32_t unique_count = 0;  // surfels with distinct positions
  float inflation_radius = 0;      // the distance within which the leaf takes in points of its neighbours
  Vector normal;                   // the normal of the leaf's plane, unit length
  Vector centre;
  bool has_surface =
      true;  // false: the points are drawn as points; the leaf and its neighbours do not triangulate them
};

struct TreeNode {
  Box box;
  float inflation_radius = 0;  // the largest radius of the leaves below
  std::uint32_t parent = none;
  std::uint32_t left = none, right = none;
  std::uint32_t leaf = none;       // `none` for an inner node
  Vector mean;                     // the mean position of the points below
  std::uint32_t unique_count = 0;  // the number of distinct positions below
  std::uint32_t representative = none;
  Vector representative_position;
};

struct StrippingTree {
  std::vector<Surfel> surfels;  // sorted by leaves
  std::vector<Leaf> leaves;
  std::vector<TreeNode> nodes;  // the root is the first node; children come after their parents

  // Returns the leaf's surfels without duplicates. Only these are triangulated and drawn.
  std::span<Surfel> unique_surfels(const Leaf& leaf) {
    return {surfels.data() + leaf.surfels.first, leaf.unique_count};
  }
  std::span<const Surfel> unique_surfels(const Leaf& leaf) const {
    return {surfels.data() + leaf.surfels.first, leaf.unique_count};
  }
};

// Recomputes box, mean and representative of a node from its children, or from the points of its leaf.
void refit(StrippingTree& tree, std::uint32_t node);

}  // namespace glark::surfel
