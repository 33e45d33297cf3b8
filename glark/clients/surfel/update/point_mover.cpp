// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/update/point_mover.h"

#include <algorithm>
#include <functional>

#include "glark/clients/surfel/tree/tree_builder.h"
#include "glark/clients/surfel/triangulate/leaf_inflation.h"

namespace glark::surfel {
namespace {

constexpr float most_stretch = 2;  // if all points of a leaf move and it grows more than this, they look for new leaves

}  // namespace

std::vector<std::uint32_t> PointMover::run() {
  touch_old_leaves();
  add_touched_and_neighbours();
  remove_moved_points();
  touch_new_leaves();
  add_touched_and_neighbours();
  resize_point_arrays();
  rebuild_touched_leaves();
  refit_ancestors();
  add_touched_and_neighbours();
  return std::move(affected_.list());
}

void PointMover::touch(std::uint32_t leaf, Vector position) {
  touched_.add(leaf);
  if (leaf >= touched_positions_.size()) touched_positions_.resize(leaf + 1);
  touched_positions_[leaf].push_back(position);
}

void PointMover::touch_old_leaves() {
  for (const Surfel& surfel : moved_) {
    if (surfel.index < level_.owner.size()) touch(level_.owner[surfel.index], level_.surfel(surfel.index).position);
  }
}

void PointMover::touch_new_leaves() {
  for (std::size_t i = 0; i < moved_.size(); ++i) arrivals_.push_back({new_leaf_of(moved_[i]), i});
  for (const Arrival& arrival : arrivals_) touch(arrival.leaf, moved_[arrival.point].position);
  std::stable_sort(arrivals_.begin(), arrivals_.end(),
                   [](const Arrival& a, const Arrival& b) { return a.leaf < b.leaf; });
}

// Adds the touched leaves, and the neighbours that take in points at touched positions.
void PointMover::add_touched_and_neighbours() {
  std::vector<std::uint32_t> neighbours;
  for (const std::uint32_t leaf : touched_.list()) {
    affected_.add(leaf);
    find_neighbours(tree_, leaf, neighbours);
    for (const std::uint32_t neighbour : neighbours) {
      const float radius = std::max(tree_.leaves[leaf].inflation_radius, tree_.leaves[neighbour].inflation_radius);
      const Box& box = tree_.nodes[tree_.leaves[neighbour].node].box;
      const bool is_new = leaf >= touched_positions_.size() || touched_positions_[leaf].empty();
      const auto is_near = [&](Vector position) { return squared_distance(box, position) <= radius * radius; };
      if (is_new || affected_.has(neighbour) || std::ranges::any_of(touched_positions_[leaf], is_near)) {
        affected_.add(neighbour);
      }
    }
  }
}

// A leaf moves as a whole if all its points move and stay close together. Other points are removed from their leaves.
void PointMover::remove_moved_points() {
  std::vector<Box> new_boxes(touched_.list().size());
  std::vector<std::uint8_t> is_moved(level_.owner.size(), 0);
  std::vector<std::uint32_t> counts(new_boxes.size(), 0);
  touched_index_.assign(tree_.leaves.size(), none);
  for (std::uint32_t k = 0; k < new_boxes.size(); ++k) touched_index_[touched_.list()[k]] = k;
  for (const Surfel& surfel : moved_) {
    if (surfel.index >= level_.owner.size()) continue;
    const std::uint32_t k = touched_index_[level_.owner[surfel.index]];
    new_boxes[k].add(surfel.position);
    ++counts[k];
    is_moved[surfel.index] = 1;
  }
  for (std::uint32_t k = 0; k < new_boxes.size(); ++k) {
    Leaf& leaf = tree_.leaves[touched_.list()[k]];
    const float old_size = length(tree_.nodes[leaf.node].box.extent());
    moves_as_whole_.push_back(counts[k] == leaf.surfels.count &&
                              length(new_boxes[k].extent()) <= most_stretch * old_size);
    remove_from_leaf(leaf, is_moved, moves_as_whole_.back());
  }
}

void PointMover::remove_from_leaf(Leaf& leaf, const std::vector<std::uint8_t>& is_moved, bool keep_box) {
  Surfel* const first = tree_.surfels.data() + leaf.surfels.first;
  Surfel* const end = std::remove_if(first, first + leaf.surfels.count,
                                     [&](const Surfel& surfel) { return is_moved[surfel.index] != 0; });
  leaf.surfels.count = static_cast<std::uint32_t>(end - first);
  if (keep_box) return;
  tree_.nodes[leaf.node].box = {};
  for (const Surfel* surfel = first; surfel != end; ++surfel) tree_.nodes[leaf.node].box.add(surfel->position);
}

// Descends from the root, always to the nearer box. Points of a leaf that moves as a whole stay in the leaf.
std::uint32_t PointMover::new_leaf_of(const Surfel& surfel) const {
  if (surfel.index < level_.owner.size()) {
    const std::uint32_t owner = level_.owner[surfel.index];
    if (moves_as_whole_[touched_index_[owner]]) return owner;
  }
  std::uint32_t node = 0;
  while (tree_.nodes[node].leaf == none) {
    const TreeNode& parent = tree_.nodes[node];
    const float left = squared_distance(tree_.nodes[parent.left].box, surfel.position);
    const float right = squared_distance(tree_.nodes[parent.right].box, surfel.position);
    node = left <= right ? parent.left : parent.right;
  }
  return tree_.nodes[node].leaf;
}

// Some moved points may be new.
void PointMover::resize_point_arrays() {
  const std::size_t count = std::max<std::size_t>(level_.owner.size(), moved_.empty() ? 0 : moved_.back().index + 1UL);
  level_.owner.resize(count);
  level_.place.resize(count);
  level_.positions.resize(count);
  level_.region_of.resize(count, none);
}

void PointMover::rebuild_touched_leaves() {
  const std::size_t old_leaves = tree_.leaves.size();
  for (const std::uint32_t leaf : touched_.list()) rebuild(leaf);
  for (std::size_t leaf = old_leaves; leaf < tree_.leaves.size(); ++leaf) {
    touched_.add(static_cast<std::uint32_t>(leaf));
  }
  level_.patches.resize(tree_.leaves.size());
}

// Adds the arrivals. Splits the leaf if it has too many points or is no longer a height field.
void PointMover::rebuild(std::uint32_t number) {
  const auto first = std::lower_bound(arrivals_.begin(), arrivals_.end(), number,
                                      [](const Arrival& a, std::uint32_t leaf) { return a.leaf < leaf; });
  auto end = first;
  while (end != arrivals_.end() && end->leaf == number) ++end;
  Slot slot = tree_.leaves[number].surfels;
  const auto count = slot.count + static_cast<std::uint32_t>(end - first);
  if (count > slot.capacity) {
    const auto to = static_cast<std::uint32_t>(tree_.surfels.size());
    tree_.surfels.resize(tree_.surfels.size() + count);
    std::copy_n(tree_.surfels.begin() + slot.first, slot.count, tree_.surfels.begin() + to);
    slot = {to, slot.count, count};
  }
  for (auto arrival = first; arrival != end; ++arrival) {
    tree_.surfels[slot.first + slot.count++] = moved_[arrival->point];
  }
  const std::size_t leaves_before = tree_.leaves.size();
  rebuild_leaf(tree_, tree_.leaves[number].node, slot, options_.tree);
  level_.register_points(number);
  for (std::size_t leaf = leaves_before; leaf < tree_.leaves.size(); ++leaf) {
    level_.register_points(static_cast<std::uint32_t>(leaf));
  }
}

void PointMover::refit_ancestors() {
  IndexSet ancestors;
  for (const std::uint32_t leaf : touched_.list()) {
    std::uint32_t node = tree_.nodes[tree_.leaves[leaf].node].parent;
    for (; node != none && !ancestors.has(node); node = tree_.nodes[node].parent) ancestors.add(node);
  }
  std::sort(ancestors.list().begin(), ancestors.list().end(), std::greater<>());  // children have higher numbers
  for (const std::uint32_t node : ancestors.list()) refit(tree_, node);
}

}  // namespace glark::surfel
