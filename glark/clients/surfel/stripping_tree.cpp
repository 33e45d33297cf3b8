// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/stripping_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>

#include "glark/clients/surfel/height_field.h"

namespace glark::surfel {
namespace {

constexpr std::size_t parallel_grain = 8192;  // points below which a branch is grown by one
constexpr std::size_t least_thick = 16;  // points that are not split for being thick: layers and noise are no shape

// A subtree of its own. Its first node is its root.
struct Branch {
  std::vector<TreeNode> nodes;
  std::vector<Leaf> leaves;

  void append(const Branch& other) {
    const auto node = static_cast<std::uint32_t>(nodes.size());
    const auto leaf = static_cast<std::uint32_t>(leaves.size());
    for (TreeNode copy : other.nodes) {
      copy.parent = copy.parent == none ? none : copy.parent + node;
      if (copy.leaf == none) {
        copy.left += node;
        copy.right += node;
      } else {
        copy.leaf += leaf;
      }
      nodes.push_back(copy);
    }
    for (Leaf copy : other.leaves) {
      copy.node += node;
      leaves.push_back(copy);
    }
  }
};

class Gardener {
 public:
  Gardener(std::span<Surfel> surfels, const TreeOptions& options, const Workers* workers)
      : surfels_(surfels), options_(options), workers_(workers) {}

  // Appends the subtree of surfels begin .. end to a branch, and returns its root.
  std::uint32_t grow(Branch& branch, std::size_t begin, std::size_t end) const {
    Box box;
    for (std::size_t i = begin; i < end; ++i) box.add(surfels_[i].position);
    if (end - begin <= options_.leaf_points || box.low == box.high) {
      return grow_leaves(branch, begin, end);
    }
    const std::size_t leaves = (end - begin + options_.leaf_points - 1) / options_.leaf_points;
    const std::size_t middle = split(begin, end, box, begin + (end - begin) * (leaves / 2) / leaves);
    return join(
        branch, end - begin, [&](Branch& to) { return grow(to, begin, middle); },
        [&](Branch& to) { return grow(to, middle, end); });
  }

 private:
  template <typename Left, typename Right>
  std::uint32_t join(Branch& branch, std::size_t count, const Left& left, const Right& right) const {
    const auto node = static_cast<std::uint32_t>(branch.nodes.size());
    branch.nodes.emplace_back();
    std::array<std::uint32_t, 2> children{};
    if (workers_ != nullptr && count > parallel_grain) {
      std::array<Branch, 2> sides;
      workers_->both([&] { left(sides[0]); }, [&] { right(sides[1]); });
      for (std::size_t k = 0; k < 2; ++k) {
        children[k] = static_cast<std::uint32_t>(branch.nodes.size());
        branch.append(sides[k]);
      }
    } else {
      children = {left(branch), none};
      children[1] = right(branch);
    }
    branch.nodes[node].left = children[0];
    branch.nodes[node].right = children[1];
    for (const std::uint32_t child : children) branch.nodes[child].parent = node;
    return node;
  }

  // About there along the widest axis. Points of equal coordinates, and so those at one place, stay together.
  std::size_t split(std::size_t begin, std::size_t end, const Box& box, std::size_t middle) const {
    const std::size_t axis = box.widest_axis();
    const auto coordinate = axis == 0 ? &Vector::x : axis == 1 ? &Vector::y : &Vector::z;
    const auto at = [&](std::size_t i) { return surfels_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [coordinate](const Surfel& a, const Surfel& b) {
      const float x = a.position.*coordinate, y = b.position.*coordinate;
      return x < y || (x == y && a.index < b.index);
    });
    const float value = surfels_[middle].position.*coordinate;
    const auto below = std::partition(at(begin), at(middle),
                                      [&](const Surfel& surfel) { return surfel.position.*coordinate < value; });
    const auto above =
        std::partition(at(middle), at(end), [&](const Surfel& surfel) { return surfel.position.*coordinate <= value; });
    const auto low = static_cast<std::size_t>(below - surfels_.begin());
    const auto high = static_cast<std::size_t>(above - surfels_.begin());
    return low > begin && (high == end || middle - low <= high - middle) ? low : high;
  }

  // The height-field criterion. A fold is split by the normals, so that the two sides of a thin sheet part.
  std::uint32_t grow_leaves(Branch& branch, std::size_t begin, std::size_t end) const {
    const std::span<Surfel> surfels = surfels_.subspan(begin, end - begin);
    const Plane plane = fit_plane(surfels);
    const Shape shape = shape_of(surfels, plane, options_);
    std::size_t middle = begin;
    if (shape == Shape::folded) {
      middle = begin + split_by_normals(surfels, plane);
    } else if (shape == Shape::thick && surfels.size() >= least_thick) {
      Box box;
      for (const Surfel& surfel : surfels) box.add(surfel.position);
      if (!(box.low == box.high)) middle = split(begin, end, box, begin + (end - begin) / 2);
    }
    if (middle == begin || middle == end) return make_leaf(branch, begin, end);
    return join(
        branch, end - begin, [&](Branch& to) { return grow_leaves(to, begin, middle); },
        [&](Branch& to) { return grow_leaves(to, middle, end); });
  }

  std::uint32_t make_leaf(Branch& branch, std::size_t begin, std::size_t end) const {
    const std::span<Surfel> surfels = surfels_.subspan(begin, end - begin);
    std::sort(surfels.begin(), surfels.end(), [](const Surfel& a, const Surfel& b) {
      return std::tie(a.position.x, a.position.y, a.position.z, a.index) <
             std::tie(b.position.x, b.position.y, b.position.z, b.index);
    });
    const auto count = static_cast<std::uint32_t>(surfels.size());
    Leaf leaf{.node = static_cast<std::uint32_t>(branch.nodes.size()),
              .surfels = {static_cast<std::uint32_t>(begin), count, count},
              .used = put_copies_last(surfels),
              .band = 0,
              .normal = {},
              .centre = {}};
    const Plane plane = fit_plane(surfels.first(leaf.used));
    leaf.normal = plane.normal;
    leaf.centre = plane.centre;
    leaf.band = options_.inflation * mean_distance(surfels.first(leaf.used), plane);
    TreeNode node;
    node.leaf = static_cast<std::uint32_t>(branch.leaves.size());
    branch.leaves.push_back(leaf);
    branch.nodes.push_back(node);
    return leaf.node;
  }

  // Of sorted surfels; how many places there are.
  static std::uint32_t put_copies_last(std::span<Surfel> surfels) {
    const auto same = [](const Surfel& a, const Surfel& b) { return a.position == b.position; };
    if (std::adjacent_find(surfels.begin(), surfels.end(), same) == surfels.end()) {
      return static_cast<std::uint32_t>(surfels.size());
    }
    std::vector<Surfel> used;
    std::vector<Surfel> copies;
    for (const Surfel& surfel : surfels) {
      (used.empty() || !same(used.back(), surfel) ? used : copies).push_back(surfel);
    }
    std::copy(copies.begin(), copies.end(), std::copy(used.begin(), used.end(), surfels.begin()));
    return static_cast<std::uint32_t>(used.size());
  }

  std::span<Surfel> surfels_;
  const TreeOptions& options_;
  const Workers* workers_;
};

void refit_leaf(StrippingTree& tree, TreeNode& node) {
  const Leaf& leaf = tree.leaves[node.leaf];
  node.box = {};
  node.band = leaf.used > 0 ? leaf.band : 0;
  node.mean = leaf.centre;
  node.used = leaf.used;
  node.representative = none;
  float nearest = std::numeric_limits<float>::infinity();
  for (const Surfel& surfel : tree.used(leaf)) {
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
  node.band = std::max(left.band, right.band);
  node.used = left.used + right.used;
  const float share = node.used > 0 ? static_cast<float>(left.used) / static_cast<float>(node.used) : 1;
  node.mean = left.mean * share + right.mean * (1 - share);
  const auto away = [&](const TreeNode& child) { return length(child.representative_position - node.mean); };
  const bool take_left = right.used == 0 || (left.used > 0 && away(left) <= away(right));
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

StrippingTree build_tree(std::vector<Surfel> surfels, const TreeOptions& options, const Workers& workers) {
  StrippingTree tree;
  tree.surfels = std::move(surfels);
  Branch branch;
  const Gardener gardener(tree.surfels, options, &workers);
  gardener.grow(branch, 0, tree.surfels.size());
  tree.nodes = std::move(branch.nodes);
  tree.leaves = std::move(branch.leaves);
  constexpr std::size_t grain = 256;
  workers.in_pieces(tree.leaves.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) refit(tree, tree.leaves[leaf].node);
  });
  for (auto node = static_cast<std::uint32_t>(tree.nodes.size()); node-- > 0;) {
    if (tree.nodes[node].leaf == none) refit(tree, node);  // children come after their parents
  }
  return tree;
}

void plant(StrippingTree& tree, std::uint32_t node, Slot surfels, const TreeOptions& options) {
  Branch branch;
  const Gardener gardener(tree.surfels, options, nullptr);
  gardener.grow(branch, surfels.first, surfels.first + surfels.count);
  const auto first_node = static_cast<std::uint32_t>(tree.nodes.size()) - 1;  // the root takes the place of `node`
  const std::uint32_t old_leaf = tree.nodes[node].leaf;
  const auto first_leaf = static_cast<std::uint32_t>(tree.leaves.size()) - 1;  // and the first leaf that of its leaf
  const auto node_number = [&](std::uint32_t n) { return n == 0 ? node : first_node + n; };
  const auto leaf_number = [&](std::uint32_t n) { return n == 0 ? old_leaf : first_leaf + n; };
  tree.nodes.resize(tree.nodes.size() + branch.nodes.size() - 1);
  tree.leaves.resize(tree.leaves.size() + branch.leaves.size() - 1);
  for (std::uint32_t n = 0; n < branch.nodes.size(); ++n) {
    TreeNode copy = branch.nodes[n];
    copy.parent = n == 0 ? tree.nodes[node].parent : node_number(copy.parent);
    if (copy.leaf == none) {
      copy.left = node_number(copy.left);
      copy.right = node_number(copy.right);
    } else {
      copy.leaf = leaf_number(copy.leaf);
    }
    tree.nodes[node_number(n)] = copy;
  }
  for (std::uint32_t n = 0; n < branch.leaves.size(); ++n) {
    branch.leaves[n].node = node_number(branch.leaves[n].node);
    tree.leaves[leaf_number(n)] = branch.leaves[n];
  }
  if (branch.leaves.size() == 1) tree.leaves[old_leaf].surfels.capacity = surfels.capacity;
  for (auto n = static_cast<std::uint32_t>(branch.nodes.size()); n-- > 0;) refit(tree, node_number(n));
}

}  // namespace glark::surfel
