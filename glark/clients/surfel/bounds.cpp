// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/bounds.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glark::surfel {
namespace {

constexpr float no_cone = 2;
constexpr float slack = 1e-3F;  // radians: cones stay around what they hold in spite of rounding

float angle_between(Vector a, Vector b) { return std::acos(std::clamp(dot(a, b), -1.0F, 1.0F)); }

// Both cones within one about the mean of their axes.
void join_cones(const Node& a, const Node& b, Node& node) {
  node.cone_sine = no_cone;
  const Vector first = to_vector(a.cone_axis), second = to_vector(b.cone_axis);
  const Vector axis = unit(first + second);
  node.cone_axis = to_array(axis);
  if (a.cone_sine >= 1 || b.cone_sine >= 1 || axis == Vector{}) return;
  const float half_angle = slack + std::max(std::asin(a.cone_sine) + angle_between(axis, first),
                                            std::asin(b.cone_sine) + angle_between(axis, second));
  constexpr float right_angle = 1.5707F;
  if (half_angle < right_angle) node.cone_sine = std::sin(half_angle);
}

// Where planes meet that touch the sphere about the box, whose normals are those of the cone's surface.
void place_apex(Node& node) {
  const Vector low = to_vector(node.low), high = to_vector(node.high);
  const float cosine = std::sqrt(std::max(0.0F, 1 - node.cone_sine * node.cone_sine));
  const float back = cosine > 0 ? 0.5F * length(high - low) / cosine : 0;
  node.cone_apex = to_array((low + high) * 0.5F - to_vector(node.cone_axis) * back);
}

bool draws_nothing(const Node& node) { return node.low[0] > node.high[0]; }

void describe_leaf(const Layer& layer, const LayerOptions& options, std::uint32_t leaf, Node& node) {
  const Patch& patch = layer.patches[leaf];
  node.low = to_array(patch.box.empty() ? patch.box.low : patch.box.low * options.unit);
  node.high = to_array(patch.box.empty() ? patch.box.high : patch.box.high * options.unit);
  node.cone_axis = to_array(patch.cone_axis);
  const float half_angle = std::acos(std::clamp(patch.cone_cosine, -1.0F, 1.0F)) + slack;
  node.cone_sine = options.oriented && patch.cone_cosine > 2 * slack ? std::sin(half_angle) : no_cone;
  node.cone_apex = to_array(patch.cone_apex * options.unit);
  node.first = patch.strip.first;
  node.count = patch.strip.count;
}

void describe_inner(const Node& left, const Node& right, Node& node) {
  for (std::size_t k = 0; k < 3; ++k) {
    node.low[k] = std::min(left.low[k], right.low[k]);
    node.high[k] = std::max(left.high[k], right.high[k]);
  }
  if (draws_nothing(left) || draws_nothing(right)) {
    const Node& one = draws_nothing(left) ? right : left;
    node.cone_axis = one.cone_axis;
    node.cone_sine = one.cone_sine;
    node.cone_apex = one.cone_apex;
  } else {
    join_cones(left, right, node);
    place_apex(node);
  }
}

}  // namespace

// The axis is the mean of the normals by area. The apex lies behind all planes of triangles, as near as it can to the box.
// Based on: meshoptimizer's bounds of clusters (Kapoulkine).
void bound(const Layer& layer, std::span<const StripTriangle> triangles, Patch& patch) {
  patch.box = {};
  Vector sum;
  thread_local std::vector<Vector> normals;
  normals.clear();
  constexpr float small = 1e-28F;  // the square of a size below which squares are no measure
  for (const auto& [a, b, c] : triangles) {
    const Vector p = layer.positions[a], q = layer.positions[b], r = layer.positions[c];
    patch.box.low = least(patch.box.low, least(p, least(q, r)));
    patch.box.high = greatest(patch.box.high, greatest(p, greatest(q, r)));
    const Vector normal = cross(q - p, r - p);
    sum = sum + normal;
    normals.push_back(dot(normal, normal) > small ? normal : unit(normal));
  }
  patch.cone_axis = unit(sum);
  float squared_cosine = 1;  // with the sign of the cosine
  const Vector centre = patch.box.centre();
  float back = -Box::far;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vector& normal = normals[i];
    const float along = dot(normal, patch.cone_axis), squared = dot(normal, normal);
    if (!(squared > 0)) continue;
    squared_cosine = std::min(squared_cosine, along * std::fabs(along) / squared);
    back = std::max(back, dot(centre - layer.positions[triangles[i][0]], normal) / along);
  }
  const float margin = slack * length(patch.box.extent());
  patch.cone_apex = back > -Box::far ? centre - patch.cone_axis * (back + margin) : centre;
  patch.cone_cosine = std::copysign(std::sqrt(std::fabs(squared_cosine)), squared_cosine);
}

void describe(Layer& layer, std::uint32_t number, const LayerOptions& options) {
  const TreeNode& tree_node = layer.tree.nodes[number];
  Node node{};
  node.left = tree_node.left;
  node.right = tree_node.right;
  node.representative = tree_node.representative == none ? none : layer.name(tree_node.representative);
  if (tree_node.leaf != none) {
    describe_leaf(layer, options, tree_node.leaf, node);
  } else {
    describe_inner(layer.nodes[node.left], layer.nodes[node.right], node);
  }
  layer.nodes[number] = node;
}

}  // namespace glark::surfel
