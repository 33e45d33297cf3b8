// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/inflation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glark::surfel {
namespace {

constexpr float opposite = -0.5F;        // the cosine to the leaf's normal below which a point is of another sheet
constexpr std::size_t most_taken = 256;  // points that a leaf takes in, for one that is sparse among dense ones

}  // namespace

void find_neighbours(const StrippingTree& tree, std::uint32_t number, std::vector<std::uint32_t>& found) {
  const Leaf& leaf = tree.leaves[number];
  const Box& box = tree.nodes[leaf.node].box;
  found.clear();
  if (leaf.used == 0) return;
  std::array<std::uint32_t, 128> stack;
  std::vector<std::uint32_t> deeper;  // trees of clouds that are anything but uniform
  std::size_t height = 0;
  const auto push = [&](std::uint32_t node) {
    height < stack.size() ? void(stack[height++] = node) : deeper.push_back(node);
  };
  push(0);
  while (height > 0 || !deeper.empty()) {
    std::uint32_t at = 0;
    if (!deeper.empty()) {
      at = deeper.back();
      deeper.pop_back();
    } else {
      at = stack[--height];
    }
    const TreeNode& node = tree.nodes[at];
    const float band = std::max(leaf.band, node.band);
    if (node.used == 0 || squared_distance(box, node.box) > band * band) continue;
    if (node.leaf == none) {
      push(node.right);
      push(node.left);
    } else if (node.leaf != number) {
      found.push_back(node.leaf);
    }
  }
}

// Over the plane, and the height. What bends away is unrolled, for as far as it bends about the leaf: a wall at a right angle stays a wall,
// not a line. So a crease is covered from either side, and leaves of different planes agree on more edges.
std::array<float, 3> Inflation::unrolled(const Surfel& surfel) const {
  const Vector d = surfel.position - leaf_->centre;
  const float x = dot(d, u_), y = dot(d, v_), height = dot(d, leaf_->normal);
  const float radius = std::sqrt(x * x + y * y);
  const float cosine = surfel.normal == Vector{} ? 1.0F : std::clamp(dot(surfel.normal, leaf_->normal), opposite, 1.0F);
  const float longer = radius > 0 ? 1 + std::fabs(height) / radius * std::sqrt((1 - cosine) / (1 + cosine)) : 1.0F;
  return {x * longer, y * longer, height};
}

void Inflation::take(const Surfel& surfel, const std::array<float, 3>& at) {
  members.push_back({surfel.position, surfel.index, surfel.normal, at});
}

void Inflation::take_own() {
  members.clear();
  own_places_.clear();
  low_ = Box::far;
  high_ = -Box::far;
  for (const Surfel& surfel : tree_.used(*leaf_)) {
    const std::array<float, 3> at = unrolled(surfel);
    take(surfel, at);
    own_places_.push_back({at[0], at[1]});
    low_ = std::min(low_, at[2]);
    high_ = std::max(high_, at[2]);
  }
  own = members.size();
}

void Inflation::take_near(const Leaf& neighbour) {
  const float band = std::max(leaf_->band, neighbour.band);
  const std::span<const Surfel> used = tree_.used(neighbour);  // ascending by x
  auto surfel =
      std::partition_point(used.begin(), used.end(), [&](const Surfel& s) { return s.position.x < box_.low.x - band; });
  for (; surfel != used.end() && surfel->position.x <= box_.high.x + band; ++surfel) {
    if (squared_distance(box_, surfel->position) > band * band) continue;
    if (!(surfel->normal == Vector{}) && dot(surfel->normal, leaf_->normal) < opposite) continue;
    const std::array<float, 3> at = unrolled(*surfel);
    if (at[2] < low_ - band || at[2] > high_ + band || !nearness_.is_near({at[0], at[1]}, band)) continue;
    take(*surfel, at);
  }
}

void Inflation::keep_nearest() {
  if (members.size() <= own + most_taken) return;
  const auto from = members.begin() + static_cast<std::ptrdiff_t>(own);
  std::nth_element(from, from + most_taken, members.end(), [&](const Member& a, const Member& b) {
    return std::pair(squared_distance(box_, a.position), a.index) <
           std::pair(squared_distance(box_, b.position), b.index);
  });
  members.resize(own + most_taken);
}

void Inflation::scale() {
  const auto reach_of = [](std::span<const Member> some) {
    float farthest = 0;
    for (const Member& member : some) farthest = std::max({farthest, std::fabs(member.at[0]), std::fabs(member.at[1])});
    return farthest;
  };
  float farthest = reach_of(members);
  // Of a leaf that is dense among sparse ones, its own points must not fall together: of what is far beyond, the direction counts.
  constexpr float most_apart = 1024;
  const float most = most_apart * reach_of(std::span(members).first(own));
  if (most > 0 && farthest > most) {
    farthest = most;
    for (Member& member : members) {
      const float beyond = std::max({1.0F, std::fabs(member.at[0]) / most, std::fabs(member.at[1]) / most});
      member.at[0] /= beyond;
      member.at[1] /= beyond;
    }
  }
  const double scale = farthest > 0 ? Delaunay::greatest / double{farthest} : 0;
  places.clear();
  for (const Member& member : members) {
    places.push_back({static_cast<std::int32_t>(std::lrint(member.at[0] * scale)),
                      static_cast<std::int32_t>(std::lrint(member.at[1] * scale))});
  }
}

void Inflation::make(std::uint32_t number) {
  leaf_ = &tree_.leaves[number];
  box_ = tree_.nodes[leaf_->node].box;
  u_ = perpendicular(leaf_->normal);
  v_ = cross(leaf_->normal, u_);
  take_own();
  find_neighbours(tree_, number, neighbours_);
  float most = leaf_->band;
  for (const std::uint32_t other : neighbours_) most = std::max(most, tree_.leaves[other].band);
  nearness_.begin(own_places_, most);
  for (const std::uint32_t other : neighbours_) take_near(tree_.leaves[other]);
  keep_nearest();
  scale();
}

}  // namespace glark::surfel
