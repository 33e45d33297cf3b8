// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/tree_builder.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "glark/clients/surfel/tree/plane_fit.h"

namespace glark::surfel {
namespace {

constexpr std::size_t parallel_grain = 8192;  // smaller subtrees are built by a single thread
constexpr std::size_t fewest_to_flatten =
    16;  // thick leaves with fewer points are not split: their shape is only noise
// Noise falls into small leaves, of which many stay thick or are crumbs of a few points. Their triangulations would cost much
// and show nothing. In scans of surfaces, nearly all groups of leaf_points points have less noise and larger leaves. Smaller
// groups may be a thin part of a surface.
constexpr double most_noise = 0.3;          // as a share of the points
constexpr std::size_t fewest_in_leaf = 24;  // on average
constexpr std::size_t fewest_without_surface = 48;
constexpr std::size_t most_in_crumb = 8;

// A tree with node and leaf numbers of its own. Its first node is its root.
struct Subtree {
  std::vector<TreeNode> nodes;
  std::vector<Leaf> leaves;

  void append(const Subtree& other) {
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

class TreeBuilder {
 public:
  // workers: null for a single thread.
  TreeBuilder(std::span<Surfel> surfels, const TreeOptions& options, const common::Workers* workers)
      : surfels_(surfels), options_(options), workers_(workers) {}

  // Appends a tree over the surfels begin .. end and returns the number of its root.
  std::uint32_t build(Subtree& subtree, std::size_t begin, std::size_t end) const {
    Box box;
    for (std::size_t i = begin; i < end; ++i) box.add(surfels_[i].position);
    if (end - begin <= options_.leaf_points || box.low == box.high) return build_leaves(subtree, begin, end);
    const std::size_t leaves = (end - begin + options_.leaf_points - 1) / options_.leaf_points;
    const std::size_t middle = split(begin, end, box, begin + (end - begin) * (leaves / 2) / leaves);
    return add_inner_node(
        subtree, end - begin, [&](Subtree& to) { return build(to, begin, middle); },
        [&](Subtree& to) { return build(to, middle, end); });
  }

 private:
  template <typename Left, typename Right>
  std::uint32_t add_inner_node(Subtree& subtree, std::size_t count, const Left& left, const Right& right) const {
    const auto node = static_cast<std::uint32_t>(subtree.nodes.size());
    subtree.nodes.emplace_back();
    std::array<std::uint32_t, 2> children{};
    if (workers_ != nullptr && count > parallel_grain) {
      std::array<Subtree, 2> sides;
      workers_->both([&] { left(sides[0]); }, [&] { right(sides[1]); });
      for (std::size_t k = 0; k < 2; ++k) {
        children[k] = static_cast<std::uint32_t>(subtree.nodes.size());
        subtree.append(sides[k]);
      }
    } else {
      children = {left(subtree), none};
      children[1] = right(subtree);
    }
    subtree.nodes[node].left = children[0];
    subtree.nodes[node].right = children[1];
    for (const std::uint32_t child : children) subtree.nodes[child].parent = node;
    return node;
  }

  // Partitions the surfels along the box's widest axis, near the index `middle`. Returns the index of the split. Points
  // with equal coordinates stay on one side, so duplicates stay together.
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

  // Appends height fields, or one leaf without a surface if the surfels are noise.
  std::uint32_t build_leaves(Subtree& subtree, std::size_t begin, std::size_t end) const {
    const std::size_t nodes = subtree.nodes.size(), leaves = subtree.leaves.size();
    std::size_t noise = 0;
    const std::uint32_t root = build_height_fields(subtree, begin, end, noise);
    const std::size_t count = end - begin;
    const bool is_noise = static_cast<double>(noise) > most_noise * static_cast<double>(count) &&
                          count < fewest_in_leaf * (subtree.leaves.size() - leaves);
    if (!is_noise || count < fewest_without_surface) return root;
    subtree.nodes.resize(nodes);
    subtree.leaves.resize(leaves);
    const std::uint32_t leaf = add_leaf(subtree, begin, end);
    subtree.leaves.back().has_surface = false;
    return leaf;
  }

  // Splits the surfels until each part is a height field. Folds are split by normals. This separates the two sides of a
  // thin sheet. Adds the number of surfels in parts that stay thick, or become crumbs, to `noise`.
  std::uint32_t build_height_fields(Subtree& subtree, std::size_t begin, std::size_t end, std::size_t& noise) const {
    const std::span<Surfel> surfels = surfels_.subspan(begin, end - begin);
    const Plane plane = fit_plane(surfels);
    const Shape shape = classify_shape(surfels, plane, options_.height_field);
    std::size_t middle = begin;
    if (shape == Shape::folded) {
      middle = begin + split_by_normals(surfels, plane);
    } else if (shape == Shape::thick && surfels.size() >= fewest_to_flatten) {
      Box box;
      for (const Surfel& surfel : surfels) box.add(surfel.position);
      if (!(box.low == box.high)) middle = split(begin, end, box, begin + (end - begin) / 2);
    }
    if (middle == begin || middle == end) {
      if (shape == Shape::thick || end - begin <= most_in_crumb) noise += end - begin;
      return add_leaf(subtree, begin, end);
    }
    return add_inner_node(
        subtree, end - begin, [&](Subtree& to) { return build_height_fields(to, begin, middle, noise); },
        [&](Subtree& to) { return build_height_fields(to, middle, end, noise); });
  }

  std::uint32_t add_leaf(Subtree& subtree, std::size_t begin, std::size_t end) const {
    const std::span<Surfel> surfels = surfels_.subspan(begin, end - begin);
    std::sort(surfels.begin(), surfels.end(), [](const Surfel& a, const Surfel& b) {
      return std::tie(a.position.x, a.position.y, a.position.z, a.index) <
             std::tie(b.position.x, b.position.y, b.position.z, b.index);
    });
    const auto count = static_cast<std::uint32_t>(surfels.size());
    Leaf leaf{.node = static_cast<std::uint32_t>(subtree.nodes.size()),
              .surfels = {static_cast<std::uint32_t>(begin), count, count},
              .unique_count = move_duplicates_last(surfels),
              .inflation_radius = 0,
              .normal = {},
              .centre = {}};
    const Plane plane = fit_plane(surfels.first(leaf.unique_count));
    leaf.normal = plane.normal;
    leaf.centre = plane.centre;
    leaf.inflation_radius = options_.inflation * mean_spacing(surfels.first(leaf.unique_count), plane);
    TreeNode node;
    node.leaf = static_cast<std::uint32_t>(subtree.leaves.size());
    subtree.leaves.push_back(leaf);
    subtree.nodes.push_back(node);
    return leaf.node;
  }

  // The surfels are sorted by position and index, so the first of several duplicates stays. Returns the number of
  // distinct positions.
  static std::uint32_t move_duplicates_last(std::span<Surfel> surfels) {
    const auto same = [](const Surfel& a, const Surfel& b) { return a.position == b.position; };
    if (std::adjacent_find(surfels.begin(), surfels.end(), same) == surfels.end()) {
      return static_cast<std::uint32_t>(surfels.size());
    }
    std::vector<Surfel> unique;
    std::vector<Surfel> duplicates;
    for (const Surfel& surfel : surfels) {
      (unique.empty() || !same(unique.back(), surfel) ? unique : duplicates).push_back(surfel);
    }
    std::copy(duplicates.begin(), duplicates.end(), std::copy(unique.begin(), unique.end(), surfels.begin()));
    return static_cast<std::uint32_t>(unique.size());
  }

  std::span<Surfel> surfels_;
  const TreeOptions& options_;
  const common::Workers* workers_;
};

}  // namespace

StrippingTree build_tree(std::vector<Surfel> surfels, const TreeOptions& options, const common::Workers& workers) {
  StrippingTree tree;
  tree.surfels = std::move(surfels);
  Subtree subtree;
  TreeBuilder(tree.surfels, options, &workers).build(subtree, 0, tree.surfels.size());
  tree.nodes = std::move(subtree.nodes);
  tree.leaves = std::move(subtree.leaves);
  constexpr std::size_t grain = 256;
  workers.in_pieces(tree.leaves.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) refit(tree, tree.leaves[leaf].node);
  });
  for (auto node = static_cast<std::uint32_t>(tree.nodes.size()); node-- > 0;) {
    if (tree.nodes[node].leaf == none) refit(tree, node);  // children come after their parents
  }
  return tree;
}

void rebuild_leaf(StrippingTree& tree, std::uint32_t node, Slot surfels, const TreeOptions& options) {
  Subtree subtree;
  TreeBuilder(tree.surfels, options, nullptr).build(subtree, surfels.first, surfels.first + surfels.count);
  const auto first_node = static_cast<std::uint32_t>(tree.nodes.size()) - 1;  // the root takes the place of `node`
  const std::uint32_t old_leaf = tree.nodes[node].leaf;
  const auto first_leaf = static_cast<std::uint32_t>(tree.leaves.size()) - 1;  // the first leaf replaces the old one
  const auto node_number = [&](std::uint32_t n) { return n == 0 ? node : first_node + n; };
  const auto leaf_number = [&](std::uint32_t n) { return n == 0 ? old_leaf : first_leaf + n; };
  tree.nodes.resize(tree.nodes.size() + subtree.nodes.size() - 1);
  tree.leaves.resize(tree.leaves.size() + subtree.leaves.size() - 1);
  for (std::uint32_t n = 0; n < subtree.nodes.size(); ++n) {
    TreeNode copy = subtree.nodes[n];
    copy.parent = n == 0 ? tree.nodes[node].parent : node_number(copy.parent);
    if (copy.leaf == none) {
      copy.left = node_number(copy.left);
      copy.right = node_number(copy.right);
    } else {
      copy.leaf = leaf_number(copy.leaf);
    }
    tree.nodes[node_number(n)] = copy;
  }
  for (std::uint32_t n = 0; n < subtree.leaves.size(); ++n) {
    subtree.leaves[n].node = node_number(subtree.leaves[n].node);
    tree.leaves[leaf_number(n)] = subtree.leaves[n];
  }
  if (subtree.leaves.size() == 1) tree.leaves[old_leaf].surfels.capacity = surfels.capacity;
  for (auto n = static_cast<std::uint32_t>(subtree.nodes.size()); n-- > 0;) refit(tree, node_number(n));
}

}  // namespace glark::surfel
