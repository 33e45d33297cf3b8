// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/stripping_tree.h"

#include <algorithm>
#include <limits>

namespace glark::surfel {
namespace {

void refit_leaf(const StrippingTree& tree, TreeNode& node) {
  const Leaf& leaf = tree.leaves[node.leaf];
  node.box = {};
  node.inflation_radius = leaf.unique_count > 0 ? leaf.inflation_radius : 0;
  node.mean = leaf.centre;
  node.unique_count = leaf.unique_count;
  node.representative = none;
  float nearest = std::numeric_limits<float>::infinity();
  for (const Surfel& surfel : tree.unique_surfels(leaf)) {
    node.box.add(surfel.position);
    const Vector d = surfel.position - node.mean;
    if (!(dot(d, d) < nearest)) continue;
    nearest = dot(d, d);
    node.representative = surfel.index;
    node.representative_position = surfel.position;
  }
}

void refit_inner(const TreeNode& left, const TreeNode& right, TreeNode& node) {
  node.box = left.box;
  node.box.add(right.box);
  node.inflation_radius = std::max(left.inflation_radius, right.inflation_radius);
  node.unique_count = left.unique_count + right.unique_count;
  const float share =
      node.unique_count > 0 ? static_cast<float>(left.unique_count) / static_cast<float>(node.unique_count) : 1;
  node.mean = left.mean * share + right.mean * (1 - share);
  const auto distance = [&](const TreeNode& child) { return length(child.representative_position - node.mean); };
  const bool take_left = right.unique_count == 0 || (left.unique_count > 0 && distance(left) <= distance(right));
  const TreeNode& taken = take_left ? left : right;
  node.representative = taken.representative;
  node.representative_position = taken.representative_position;
}

}  // namespace

void refit(StrippingTree& tree, std::uint32_t number) {
  TreeNode& node = tree.nodes[number];
  if (node.leaf != none) {
    refit_leaf(tree, node);
  } else {
    refit_inner(tree.nodes[node.left], tree.nodes[node.right], node);
  }
}

}  // namespace glark::surfel
