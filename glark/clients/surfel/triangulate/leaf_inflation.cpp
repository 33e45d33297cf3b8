// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/triangulate/leaf_inflation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glark::surfel {
namespace {

// The cosine between the normals of point and leaf; with less, the point is on another sheet.
constexpr float least_cosine = -0.5F;
// The most points that a leaf takes in; a sparse leaf among dense ones would find too many.
constexpr std::size_t most_taken = 256;

}  // namespace

void find_neighbours(const StrippingTree& tree, std::uint32_t number, std::vector<std::uint32_t>& found) {
  const Leaf& leaf = tree.leaves[number];
  const Box& box = tree.nodes[leaf.node].box;
  found.clear();
  if (leaf.unique_count == 0 || !leaf.has_surface) return;
  std::array<std::uint32_t, 128> stack;
  std::vector<std::uint32_t> overflow;  // only used in deep trees of very uneven clouds
  std::size_t height = 0;
  const auto push = [&](std::uint32_t node) {
    height < stack.size() ? void(stack[height++] = node) : overflow.push_back(node);
  };
  push(0);
  while (height > 0 || !overflow.empty()) {
    std::uint32_t at = 0;
    if (!overflow.empty()) {
      at = overflow.back();
      overflow.pop_back();
    } else {
      at = stack[--height];
    }
    const TreeNode& node = tree.nodes[at];
    const float distance = std::max(leaf.inflation_radius, node.inflation_radius);
    if (node.unique_count == 0 || squared_distance(box, node.box) > distance * distance) continue;
    if (node.leaf == none) {
      push(node.right);
      push(node.left);
    } else if (node.leaf != number && tree.leaves[node.leaf].has_surface) {
      found.push_back(node.leaf);
    }
  }
}

// Projects a surfel onto the plane. Where the surface bends away from the plane, the distance from the centre grows by
// the length of the bend. So a wall at a right angle is not projected to a line. Then the leaves on both sides cover a
// crease, and neighbouring leaves agree on more edges.
std::array<float, 3> LeafInflation::unroll(const Surfel& surfel) const {
  const Vector d = surfel.position - frame_.leaf->centre;
  const float x = dot(d, frame_.u), y = dot(d, frame_.v), height = dot(d, frame_.leaf->normal);
  const float radius = std::sqrt(x * x + y * y);
  const float cosine =
      surfel.normal == Vector{} ? 1.0F : std::clamp(dot(surfel.normal, frame_.leaf->normal), least_cosine, 1.0F);
  const float stretch = radius > 0 ? 1 + std::fabs(height) / radius * std::sqrt((1 - cosine) / (1 + cosine)) : 1.0F;
  return {x * stretch, y * stretch, height};
}

void LeafInflation::add(const Surfel& surfel, const std::array<float, 3>& projected) {
  members_.push_back({surfel.position, surfel.index, surfel.normal, projected});
}

void LeafInflation::add_own_points() {
  members_.clear();
  own_places_.clear();
  frame_.low = Box::far;
  frame_.high = -Box::far;
  for (const Surfel& surfel : tree_.unique_surfels(*frame_.leaf)) {
    const std::array<float, 3> at = unroll(surfel);
    add(surfel, at);
    own_places_.push_back({at[0], at[1]});
    frame_.low = std::min(frame_.low, at[2]);
    frame_.high = std::max(frame_.high, at[2]);
  }
  own_count_ = members_.size();
}

void LeafInflation::add_nearby_points(const Leaf& neighbour) {
  const float distance = std::max(frame_.leaf->inflation_radius, neighbour.inflation_radius);
  const std::span<const Surfel> surfels = tree_.unique_surfels(neighbour);  // sorted by x
  auto surfel = std::partition_point(surfels.begin(), surfels.end(),
                                     [&](const Surfel& s) { return s.position.x < frame_.box.low.x - distance; });
  for (; surfel != surfels.end() && surfel->position.x <= frame_.box.high.x + distance; ++surfel) {
    if (squared_distance(frame_.box, surfel->position) > distance * distance) continue;
    if (!(surfel->normal == Vector{}) && dot(surfel->normal, frame_.leaf->normal) < least_cosine) continue;
    const std::array<float, 3> at = unroll(*surfel);
    if (at[2] < frame_.low - distance || at[2] > frame_.high + distance ||
        !proximity_.is_near({at[0], at[1]}, distance))
      continue;
    add(*surfel, at);
  }
}

void LeafInflation::keep_nearest() {
  if (members_.size() <= own_count_ + most_taken) return;
  const auto from = members_.begin() + static_cast<std::ptrdiff_t>(own_count_);
  std::nth_element(from, from + most_taken, members_.end(), [&](const Member& a, const Member& b) {
    return std::pair(squared_distance(frame_.box, a.position), a.index) <
           std::pair(squared_distance(frame_.box, b.position), b.index);
  });
  members_.resize(own_count_ + most_taken);
}

void LeafInflation::quantize() {
  const auto extent_of = [](std::span<const Member> some) {
    float farthest = 0;
    for (const Member& member : some)
      farthest = std::max({farthest, std::fabs(member.projected[0]), std::fabs(member.projected[1])});
    return farthest;
  };
  float farthest = extent_of(members_);
  // Far points move closer to the centre. Otherwise, the points of a dense leaf could fall onto one integer position.
  constexpr float most_extents = 1024;
  const float most = most_extents * extent_of(std::span(members_).first(own_count_));
  if (most > 0 && farthest > most) {
    farthest = most;
    for (Member& member : members_) {
      const float excess =
          std::max({1.0F, std::fabs(member.projected[0]) / most, std::fabs(member.projected[1]) / most});
      member.projected[0] /= excess;
      member.projected[1] /= excess;
    }
  }
  const double scale = farthest > 0 ? Delaunay::max_coordinate / double{farthest} : 0;
  plane_points_.clear();
  for (const Member& member : members_) {
    plane_points_.push_back({static_cast<std::int32_t>(std::lrint(member.projected[0] * scale)),
                             static_cast<std::int32_t>(std::lrint(member.projected[1] * scale))});
  }
}

void LeafInflation::inflate(std::uint32_t number) {
  frame_.leaf = &tree_.leaves[number];
  frame_.box = tree_.nodes[frame_.leaf->node].box;
  frame_.u = perpendicular(frame_.leaf->normal);
  frame_.v = cross(frame_.leaf->normal, frame_.u);
  add_own_points();
  find_neighbours(tree_, number, neighbours_);
  float greatest_radius = frame_.leaf->inflation_radius;
  for (const std::uint32_t other : neighbours_)
    greatest_radius = std::max(greatest_radius, tree_.leaves[other].inflation_radius);
  proximity_.begin(own_places_, greatest_radius);
  for (const std::uint32_t other : neighbours_) add_nearby_points(tree_.leaves[other]);
  keep_nearest();
  quantize();
}

}  // namespace glark::surfel
