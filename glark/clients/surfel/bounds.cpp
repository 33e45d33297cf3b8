// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/bounds.h"

#include <algorithm>
#include <array>
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
  const float back = cosine > 0 ? 0.5F * length_of_any(high - low) / cosine : 0;
  node.cone_apex = to_array((low + high) * 0.5F - to_vector(node.cone_axis) * back);
}

constexpr std::size_t lanes = 8;

// Of a few triangles at a time, coordinate by coordinate: so the compiler has its vectors.
struct Lanes {
  std::array<float, lanes> x, y, z;

  void set(std::size_t i, const Vector& vector) {
    x[i] = vector.x;
    y[i] = vector.y;
    z[i] = vector.z;
  }
  Vector at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

struct Planes {
  Lanes points, normals;  // a normal of zero: there is no plane
};

struct Boxes {
  Lanes low, high;

  void add(const Lanes& points) {
    for (std::size_t i = 0; i < lanes; ++i) {
      low.set(i, least(low.at(i), points.at(i)));
      high.set(i, greatest(high.at(i), points.at(i)));
    }
  }
  Box box() const {
    Box all;
    for (std::size_t i = 0; i < lanes; ++i) all.add({low.at(i), high.at(i)});
    return all;
  }
};

// How far planes are from an axis, and from a centre along that.
struct Spread {
  std::array<float, lanes> squared_cosine, behind;  // the former with the sign of the cosine

  void add(const Planes& planes, Vector axis, Vector centre) {
    for (std::size_t i = 0; i < lanes; ++i) {
      const Vector normal = planes.normals.at(i);
      const float along = dot(normal, axis), squared = dot(normal, normal);
      const float cosine = along * std::fabs(along) / squared;
      const float back = dot(centre - planes.points.at(i), normal) / along;
      const float least = cosine < squared_cosine[i] ? cosine : squared_cosine[i];
      const float farthest = back > behind[i] ? back : behind[i];
      squared_cosine[i] = squared > 0 ? least : squared_cosine[i];
      behind[i] = squared > 0 ? farthest : behind[i];
    }
  }
};

// The box and the planes of triangles, and the sum of their normals by area.
Vector measure(const Layer& layer, std::span<const StripTriangle> triangles, Box& box, std::vector<Planes>& all) {
  Boxes boxes;
  for (std::size_t i = 0; i < lanes; ++i) {
    boxes.low.set(i, box.low);
    boxes.high.set(i, box.high);
  }
  Vector sum;
  all.resize((triangles.size() + lanes - 1) / lanes);
  for (std::size_t first = 0; first < triangles.size(); first += lanes) {
    Lanes p, q, r;
    const std::size_t count = std::min(lanes, triangles.size() - first);
    for (std::size_t i = 0; i < lanes; ++i) {
      const StripTriangle& triangle =
          triangles[first + std::min(i, count - 1)];  // the last again where there are no more
      p.set(i, layer.positions[triangle[0]]);
      q.set(i, layer.positions[triangle[1]]);
      r.set(i, layer.positions[triangle[2]]);
    }
    Planes& planes = all[first / lanes];
    planes.points = p;
    std::array<float, lanes> squared;
    for (std::size_t i = 0; i < lanes; ++i) {
      const Vector normal = cross(q.at(i) - p.at(i), r.at(i) - p.at(i));
      planes.normals.set(i, normal);
      squared[i] = dot(normal, normal);
    }
    boxes.add(p);
    boxes.add(q);
    boxes.add(r);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector normal = planes.normals.at(i);
      sum = sum + normal;
      constexpr float small = 1e-28F;  // the square of a size below which squares are no measure
      if (!(squared[i] > small)) planes.normals.set(i, unit(normal));
    }
  }
  box = boxes.box();
  return sum;
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
  thread_local std::vector<Planes> all;
  patch.box = {};
  patch.cone_axis = unit(measure(layer, triangles, patch.box, all));
  const Vector centre = patch.box.centre();
  Spread spread;
  spread.squared_cosine.fill(1);
  spread.behind.fill(-Box::far);
  for (const Planes& planes : all) spread.add(planes, patch.cone_axis, centre);
  const float squared_cosine = *std::min_element(spread.squared_cosine.begin(), spread.squared_cosine.end());
  const float behind = *std::max_element(spread.behind.begin(), spread.behind.end());
  const float margin = slack * length(patch.box.extent());
  patch.cone_apex = behind > -Box::far ? centre - patch.cone_axis * (behind + margin) : centre;
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
