// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/cull/nodes.h"

#include <algorithm>
#include <cmath>

#include "glark/clients/surfel/cull/bounds.h"

namespace glark::surfel {
namespace {

constexpr float no_cone = 2;  // for a cone_sine

float angle_between(Vector a, Vector b) { return std::acos(std::clamp(dot(a, b), -1.0F, 1.0F)); }

// Computes the cone around both cones. Its axis is the mean of their axes.
void join_cones(const Node& a, const Node& b, Node& node) {
  node.cone_sine = no_cone;
  const Vector first = to_vector(a.cone_axis), second = to_vector(b.cone_axis);
  const Vector axis = unit(first + second);
  node.cone_axis = to_array(axis);
  if (a.cone_sine >= 1 || b.cone_sine >= 1 || axis == Vector{}) return;
  const float half_angle = cone_margin + std::max(std::asin(a.cone_sine) + angle_between(axis, first),
                                                  std::asin(b.cone_sine) + angle_between(axis, second));
  constexpr float right_angle = 1.5707F;
  if (half_angle < right_angle) node.cone_sine = std::sin(half_angle);
}

// The apex is where the outermost planes meet that touch the box's bounding sphere and have normals in the cone. So it
// is behind all such planes.
void place_apex(Node& node) {
  const Vector low = to_vector(node.low), high = to_vector(node.high);
  const float cosine = std::sqrt(std::max(0.0F, 1 - node.cone_sine * node.cone_sine));
  const float back = cosine > 0 ? 0.5F * robust_length(high - low) / cosine : 0;
  node.cone_apex = to_array((low + high) * 0.5F - to_vector(node.cone_axis) * back);
}

bool draws_nothing(const Node& node) { return node.low[0] > node.high[0]; }

void update_leaf_node(const Level& level, const LevelOptions& options, std::uint32_t leaf, Node& node) {
  const Patch& patch = level.patches[leaf];
  const Bounds& bounds = patch.bounds;
  node.low = to_array(bounds.box.empty() ? bounds.box.low : bounds.box.low * options.unit);
  node.high = to_array(bounds.box.empty() ? bounds.box.high : bounds.box.high * options.unit);
  node.cone_axis = to_array(bounds.cone_axis);
  const float half_angle = std::acos(std::clamp(bounds.cone_cosine, -1.0F, 1.0F)) + cone_margin;
  node.cone_sine = options.has_normals && bounds.cone_cosine > 2 * cone_margin ? std::sin(half_angle) : no_cone;
  node.cone_apex = to_array(bounds.cone_apex * options.unit);
  node.first = patch.strip.first;
  node.count = patch.strip.count;
  if (level.tree.leaves[leaf].has_surface) return;
  const Box& box = level.tree.nodes[level.tree.leaves[leaf].node].box;
  if (box.empty()) return;
  node.low = to_array(box.low * options.unit);
  node.high = to_array(box.high * options.unit);
  node.cone_sine = no_cone;
}

void update_inner_node(const Node& left, const Node& right, Node& node) {
  for (std::size_t k = 0; k < 3; ++k) {
    node.low[k] = std::min(left.low[k], right.low[k]);
    node.high[k] = std::max(left.high[k], right.high[k]);
  }
  if (draws_nothing(left) || draws_nothing(right)) {
    const Node& drawn = draws_nothing(left) ? right : left;
    node.cone_axis = drawn.cone_axis;
    node.cone_sine = drawn.cone_sine;
    node.cone_apex = drawn.cone_apex;
  } else {
    join_cones(left, right, node);
    place_apex(node);
  }
}

}  // namespace

void update_node(Level& level, std::uint32_t number, const LevelOptions& options) {
  const TreeNode& tree_node = level.tree.nodes[number];
  Node node{};
  node.left = tree_node.left;
  node.right = tree_node.right;
  node.representative = tree_node.representative == none ? none : level.cloud_index(tree_node.representative);
  if (tree_node.leaf != none) {
    update_leaf_node(level, options, tree_node.leaf, node);
  } else {
    update_inner_node(level.nodes[node.left], level.nodes[node.right], node);
  }
  level.nodes[number] = node;
}

}  // namespace glark::surfel
