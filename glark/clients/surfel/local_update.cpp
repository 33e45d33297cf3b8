// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/local_update.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "glark/clients/surfel/mending.h"

namespace glark::surfel {
namespace {

constexpr float stretch = 2;  // of a leaf all of whose points move, above which they look for new leaves

// Numbers, each once, in the order in which they came.
class Marked {
 public:
  void add(std::uint32_t number) {
    if (number >= flags_.size()) flags_.resize(number + 1, 0);
    if (flags_[number] != 0) return;
    flags_[number] = 1;
    list_.push_back(number);
  }
  bool has(std::uint32_t number) const { return number < flags_.size() && flags_[number] != 0; }
  std::vector<std::uint32_t>& list() { return list_; }

 private:
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> list_;
};

class Mover {
 public:
  Mover(Layer& layer, std::span<const Surfel> moved, const LayerOptions& options)
      : layer_(layer), tree_(layer.tree), moved_(moved), options_(options) {}

  // Takes the points to their new leaves. Afterwards `leaves` are those whose triangulations may differ.
  void run() {
    for (const Surfel& surfel : moved_) {
      if (surfel.index < layer_.owner.size()) touch(layer_.owner[surfel.index], layer_.surfel(surfel.index).position);
    }
    add_neighbours();
    take_out();
    for (std::size_t i = 0; i < moved_.size(); ++i) arrivals_.emplace_back(host_of(moved_[i]), i);
    for (const auto& [leaf, i] : arrivals_) touch(leaf, moved_[i].position);
    add_neighbours();
    std::stable_sort(arrivals_.begin(), arrivals_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    layer_.owner.resize(std::max<std::size_t>(layer_.owner.size(), moved_.empty() ? 0 : moved_.back().index + 1UL));
    layer_.place.resize(layer_.owner.size());
    layer_.positions.resize(layer_.owner.size());
    layer_.rift_of.resize(layer_.owner.size(), none);
    const std::size_t old_leaves = tree_.leaves.size();
    for (const std::uint32_t leaf : touched_.list()) replant(leaf);
    for (std::size_t leaf = old_leaves; leaf < tree_.leaves.size(); ++leaf) {
      touched_.add(static_cast<std::uint32_t>(leaf));
    }
    layer_.patches.resize(tree_.leaves.size());
    refit_above();
    add_neighbours();
  }

  Marked leaves;

 private:
  void touch(std::uint32_t leaf, Vector place) {
    touched_.add(leaf);
    if (leaf >= places_.size()) places_.resize(leaf + 1);
    places_[leaf].push_back(place);
  }

  // Those that take in points which moved, or did so.
  void add_neighbours() {
    for (const std::uint32_t leaf : touched_.list()) {
      leaves.add(leaf);
      find_neighbours(tree_, leaf, found_);
      for (const std::uint32_t neighbour : found_) {
        const float band = std::max(tree_.leaves[leaf].band, tree_.leaves[neighbour].band);
        const Box& box = tree_.nodes[tree_.leaves[neighbour].node].box;
        const bool is_new = leaf >= places_.size() || places_[leaf].empty();
        const auto is_near = [&](Vector place) { return squared_distance(box, place) <= band * band; };
        if (is_new || leaves.has(neighbour) || std::any_of(places_[leaf].begin(), places_[leaf].end(), is_near)) {
          leaves.add(neighbour);
        }
      }
    }
  }

  // A leaf of which all points move, about as far, goes with them; points of others leave theirs.
  void take_out() {
    std::vector<Box> boxes(touched_.list().size());
    std::vector<std::uint8_t> is_moved(layer_.owner.size(), 0);
    std::vector<std::uint32_t> counts(boxes.size(), 0);
    number_of_.assign(tree_.leaves.size(), none);
    for (std::uint32_t k = 0; k < boxes.size(); ++k) number_of_[touched_.list()[k]] = k;
    for (const Surfel& surfel : moved_) {
      if (surfel.index >= layer_.owner.size()) continue;
      const std::uint32_t k = number_of_[layer_.owner[surfel.index]];
      boxes[k].add(surfel.position);
      ++counts[k];
      is_moved[surfel.index] = 1;
    }
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
      Leaf& leaf = tree_.leaves[touched_.list()[k]];
      const float before = length(tree_.nodes[leaf.node].box.extent());
      stays_.push_back(counts[k] == leaf.surfels.count && length(boxes[k].extent()) <= stretch * before);
      Surfel* const first = tree_.surfels.data() + leaf.surfels.first;
      Surfel* const end = std::remove_if(first, first + leaf.surfels.count,
                                         [&](const Surfel& surfel) { return is_moved[surfel.index] != 0; });
      leaf.surfels.count = static_cast<std::uint32_t>(end - first);
      if (!stays_.back()) {
        tree_.nodes[leaf.node].box = {};
        for (const Surfel* surfel = first; surfel != end; ++surfel) tree_.nodes[leaf.node].box.add(surfel->position);
      }
    }
  }

  // Top-down to the nearer box.
  std::uint32_t host_of(const Surfel& surfel) const {
    if (surfel.index < number_of_points()) {
      const std::uint32_t owner = layer_.owner[surfel.index];
      if (stays_[number_of_[owner]]) return owner;
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
  std::size_t number_of_points() const { return layer_.owner.size(); }

  // The leaf with its arrivals, split where there are too many or they are no height field any more.
  void replant(std::uint32_t number) {
    const auto first = std::lower_bound(arrivals_.begin(), arrivals_.end(), number,
                                        [](const auto& a, std::uint32_t b) { return a.first < b; });
    auto end = first;
    while (end != arrivals_.end() && end->first == number) ++end;
    Slot slot = tree_.leaves[number].surfels;
    const auto count = slot.count + static_cast<std::uint32_t>(end - first);
    if (count > slot.capacity) {
      const auto to = static_cast<std::uint32_t>(tree_.surfels.size());
      tree_.surfels.resize(tree_.surfels.size() + count);
      std::copy_n(tree_.surfels.begin() + slot.first, slot.count, tree_.surfels.begin() + to);
      slot = {to, slot.count, count};
    }
    for (auto arrival = first; arrival != end; ++arrival) {
      tree_.surfels[slot.first + slot.count++] = moved_[arrival->second];
    }
    const std::size_t leaves_before = tree_.leaves.size();
    plant(tree_, tree_.leaves[number].node, slot, options_.tree);
    layer_.find_owners(number);
    for (std::size_t leaf = leaves_before; leaf < tree_.leaves.size(); ++leaf) {
      layer_.find_owners(static_cast<std::uint32_t>(leaf));
    }
  }

  void refit_above() {
    Marked above;
    for (const std::uint32_t leaf : touched_.list()) {
      std::uint32_t node = tree_.nodes[tree_.leaves[leaf].node].parent;
      for (; node != none && !above.has(node); node = tree_.nodes[node].parent) above.add(node);
    }
    std::sort(above.list().begin(), above.list().end(), std::greater<>());  // children have higher numbers
    for (const std::uint32_t node : above.list()) refit(tree_, node);
  }

  Layer& layer_;
  StrippingTree& tree_;
  std::span<const Surfel> moved_;
  const LayerOptions& options_;
  Marked touched_;
  std::vector<std::vector<Vector>> places_;  // of leaves, where points have moved from and to
  std::vector<std::uint32_t> found_;
  std::vector<std::uint32_t> number_of_;                         // of leaves, among the first that were touched
  std::vector<bool> stays_;                                      // of these
  std::vector<std::pair<std::uint32_t, std::size_t>> arrivals_;  // leaf, and which of the moved
};

// Mended triangles may have points that their leaf does not take in: it has not seen these move.
void note_moved(Patch& patch, std::span<const Surfel> moved) {
  const auto has_moved = [&](std::uint32_t point) {
    const auto found = std::lower_bound(moved.begin(), moved.end(), point,
                                        [](const Surfel& surfel, std::uint32_t index) { return surfel.index < index; });
    return found != moved.end() && found->index == point;
  };
  patch.moved = patch.moved || std::any_of(patch.mended.begin(), patch.mended.end(), [&](const MendedTriangle& mended) {
                  return std::any_of(mended.triangle.begin(), mended.triangle.end(), has_moved);
                });
}

template <typename Item, typename Slots>
bool move_together(std::vector<Item>& array, const Slots& slots) {
  std::size_t live = 0;
  slots([&](Slot& slot) { live += slot.count; });
  constexpr std::size_t little = 4096;
  if (array.size() <= 2 * live + little) return false;
  std::vector<Item> together;
  together.reserve(live);
  slots([&](Slot& slot) {
    const auto from = array.begin() + slot.first;
    slot.first = static_cast<std::uint32_t>(together.size());
    slot.capacity = slot.count;
    together.insert(together.end(), from, from + slot.count);
  });
  array = std::move(together);
  return true;
}

}  // namespace

void update_layer(Layer& layer, std::span<const Surfel> moved, const LayerOptions& options, const Workers& workers,
                  std::vector<std::uint32_t>& indices, std::vector<Range>& changed) {
  Mover mover(layer, moved, options);
  mover.run();
  make_candidates(layer, mover.leaves.list(), options, workers);
  // Those that share triangles with them compare anew, and those that share places of disagreement with these.
  Marked drawn;
  std::vector<std::uint32_t> found;
  for (const std::uint32_t leaf : mover.leaves.list()) {
    drawn.add(leaf);
    find_neighbours(layer.tree, leaf, found);
    for (const std::uint32_t neighbour : found) drawn.add(neighbour);
  }
  agree_on_candidates(layer, drawn.list(), options, workers);
  for (const std::uint32_t leaf : mend(layer, drawn.list(), options, workers)) drawn.add(leaf);
  for (const std::uint32_t leaf : drawn.list()) note_moved(layer.patches[leaf], moved);
  make_strips(layer, drawn.list(), options, workers, indices, changed);
  layer.nodes.resize(layer.tree.nodes.size());
  Marked nodes;
  for (const std::uint32_t leaf : drawn.list()) {
    for (std::uint32_t node = layer.tree.leaves[leaf].node; node != none && !nodes.has(node);
         node = layer.tree.nodes[node].parent) {
      nodes.add(node);
    }
  }
  std::sort(nodes.list().begin(), nodes.list().end(), std::greater<>());
  for (const std::uint32_t node : nodes.list()) describe(layer, node, options);
}

bool overgrown(const Layer& layer, const LayerOptions& options) {
  const std::size_t full = layer.owner.size() / options.tree.leaf_points;
  constexpr std::size_t few = 64;
  return layer.tree.leaves.size() > 2 * layer.planted + 4 * full + few;
}

void rebuild(Layer& layer, const LayerOptions& options, const Workers& workers, std::vector<std::uint32_t>& indices) {
  std::vector<Surfel> surfels(layer.owner.size());
  for (std::uint32_t point = 0; point < surfels.size(); ++point) surfels[point] = layer.surfel(point);
  layer = build_layer(std::move(surfels), std::move(layer.names), options, workers, indices);
}

void tidy(Layer& layer) {
  move_together(layer.candidates, [&](const auto& body) {
    for (Patch& patch : layer.patches) body(patch.candidates);
  });
  const bool moved = move_together(layer.tree.surfels, [&](const auto& body) {
    for (Leaf& leaf : layer.tree.leaves) body(leaf.surfels);
  });
  if (!moved) return;
  for (std::uint32_t leaf = 0; leaf < layer.tree.leaves.size(); ++leaf) layer.find_owners(leaf);
}

}  // namespace glark::surfel
