// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/clusters.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "glark/clients/common/mesh/reindex.h"
#include "glark/clients/vstree/simplify/quadtrees.h"
#include "glark/clients/vstree/simplify/shapes.h"
#include "glark/clients/vstree/simplify/sheets/boundary.h"
#include "glark/clients/vstree/simplify/split_clusters.h"
#include "glark/clients/vstree/tree/construction.h"
#include "glark/clients/vstree/tree/prune.h"

namespace glark::vstree {
namespace {

constexpr int most_searches = 6;
constexpr std::uint32_t most_cells =
    (1 << 21) - 1;                       // the most cells of a grid along an axis, so that three numbers fit into a key
constexpr double parts_a_cluster = 2.5;  // number of parts of the tree for each cluster

// Returns how many triangles of a mesh, or points of a point set, the clusters leave.
std::size_t size_of(const Surface& surface, const Clusters& clusters) {
  return surface.triangles.empty() ? clusters.count : clusters.triangles.size() / 3;
}

// make(k) returns about k clusters. Finds the k with the most triangles, or points, within the target. Returns the
// clusters of this k.
template <typename Make>
Clusters search(const Surface& surface, std::size_t target, const Workers& workers, const Make& make) {
  const auto wanted = static_cast<double>(target);
  Clusters best;
  std::size_t best_size = 0;
  std::size_t aim = surface.triangles.empty() ? target : std::max<std::size_t>(target / 2, 1);
  for (int i = 0; i < most_searches && aim > 0; ++i) {
    Clusters clusters = make(aim);
    std::size_t size = clusters.count;
    bool near = true;
    if (!surface.triangles.empty()) {  // removes fins only near the target
      std::vector<std::uint32_t> triangles = spanning(surface.triangles, clusters.of, workers);
      size = triangles.size() / 3;
      near = static_cast<double>(size) < 1.2 * wanted && (static_cast<double>(size) > 0.97 * wanted || i > 2);
      if (near) clusters.set_triangles(std::move(triangles));
    }
    if (near) {
      size = size_of(surface, clusters);
      const bool all = clusters.count >= surface.size();
      if (size <= target && (best.of.empty() || size > best_size)) {
        best_size = size;
        best = std::move(clusters);
      }
      if (size <= target && (static_cast<double>(size) >= 0.995 * wanted || all)) break;
    }
    const double factor = 0.998 * wanted / static_cast<double>(std::max<std::size_t>(size, 1));
    aim = static_cast<std::size_t>(static_cast<double>(aim) * std::clamp(factor, 0.25, 4.0));
  }
  while (best.of.empty()) {  // with equal errors, few numbers of clusters are possible
    aim = std::max<std::size_t>(aim / 2, 1);
    Clusters clusters = make(aim);
    clusters.set_triangles(spanning(surface.triangles, clusters.of, workers));
    if (aim == 1 || size_of(surface, clusters) <= target) best = std::move(clusters);
  }
  const std::size_t most_missing = target / 100;
  if (surface.triangles.empty() && best.count + most_missing < std::min(target, surface.size()))
    split_largest(surface, target, best);
  return best;
}

// Makes leaves of the nodes whose error is small enough.
Clusters leaves_of(std::span<const Node> nodes, std::span<const std::uint32_t> order, std::span<const float> errors,
                   float threshold) {
  Clusters clusters;
  clusters.of.resize(order.size());
  std::vector<bool> is_below(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    const bool is_leaf = node.is_leaf() || errors[i] <= threshold;
    if (is_leaf && !is_below[i]) {
      for (std::uint32_t k = node.begin; k < node.end; ++k) clusters.of[order[k]] = clusters.count;
      ++clusters.count;
    }
    if (node.is_leaf() || !(is_leaf || is_below[i])) continue;
    for (std::uint32_t k = 0; k < node.child_count(); ++k) is_below[node.first_child + k] = true;
  }
  return clusters;
}

// The error of each inner node: the sum of the squared distances of its best point from the tangent planes of its
// samples. It is not less than the error of a node below. With the sum instead of the mean, nodes are divided where the
// whole surface gains most. A small share of the extent is added, so that flat parts are divided evenly.
class WholeErrors {
 public:
  WholeErrors(std::span<const Node> nodes, std::span<const Record> sorted, const Workers& workers)
      : nodes_(nodes), sorted_(sorted), workers_(workers), errors_(nodes.size()) {
    if (!nodes.empty()) find_shared(0);
  }
  const std::vector<float>& errors() const { return errors_; }

 private:
  // Returns the shape of a node. Other threads may take its children.
  Shape find_shared(std::uint32_t index) {
    const Node& node = nodes_[index];
    constexpr std::uint32_t samples_alone = 1 << 12;
    if (node.size() <= samples_alone || node.is_leaf()) {
      std::vector<Shape> stack;
      find(index, stack);
      return stack.back();
    }
    std::vector<Shape> children(node.child_count());
    workers_.each(children.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        children[k] = find_shared(node.first_child + static_cast<std::uint32_t>(k));
    });
    return combine(node, children);
  }

  // Pushes the shape of a node onto the stack.
  void find(std::uint32_t index, std::vector<Shape>& stack) {
    const Node& node = nodes_[index];
    if (node.is_leaf()) {
      stack.push_back(shape_of(sorted_.subspan(node.begin, node.size())));
      return;
    }
    const std::uint32_t count = node.child_count();
    for (std::uint32_t k = 0; k < count; ++k) find(node.first_child + k, stack);
    const Shape shape = combine(node, std::span(stack).last(count));
    stack.resize(stack.size() - count);
    stack.push_back(shape);
  }

  Shape combine(const Node& node, std::span<const Shape> children) {
    const Shape shape = sum_of(children);
    float error = shape.error();
    for (std::size_t k = 0; k < children.size(); ++k) error = std::max(error, errors_[node.first_child + k]);
    errors_[static_cast<std::size_t>(&node - nodes_.data())] = error;
    return shape;
  }

  std::span<const Node> nodes_;
  std::span<const Record> sorted_;
  const Workers& workers_;
  std::vector<float> errors_;
};

Options tree_options_for(const Surface& surface, const SimplifyOptions& options) {
  Options tree_options;
  tree_options.surface = options.clustering == Clustering::volume_surface;
  tree_options.metric = options.metric;
  tree_options.threshold = options.threshold;
  tree_options.delta_a = options.delta_a;
  tree_options.delta_d = options.delta_d;
  if (options.target != 0) {
    const std::size_t clusters = surface.triangles.empty() ? options.target : options.target / 2 + 1;
    tree_options.metric = Metric::density;
    tree_options.threshold =
        std::max(1.0F, std::floor(static_cast<float>(static_cast<double>(surface.size()) /
                                                     (parts_a_cluster * static_cast<double>(clusters)))));
  }
  return tree_options;
}

// The quadtrees of the layer of a volume-surface tree, with planes along the boundaries of the surface where it has some.
Clusters cluster_by_quadtrees(const Surface& surface, std::size_t target, const Nodes& layer, const Records& sorted,
                              std::size_t samples, const Workers& workers) {
  const auto with = [&](const BoundaryPlanes* boundary) {
    const Quadtrees quadtrees(layer, sorted.all(), samples, boundary, workers);
    return search(surface, target, workers, [&](std::size_t aim) {
      Clusters clusters;
      clusters.count = quadtrees.cluster(aim, clusters.of);
      return clusters;
    });
  };
  Clusters clusters = with(nullptr);
  std::vector<BoundaryEdge> boundary = boundary_edges(surface, clusters);
  if (!boundary.empty()) {
    const BoundaryPlanes planes(surface, boundary);
    clusters = with(&planes);
  }
  clusters.boundary = std::move(boundary);
  return clusters;
}

Clusters cluster_by_tree(const Surface& surface, const SimplifyOptions& options, const Workers& workers) {
  const Options tree_options = tree_options_for(surface, options);
  std::vector<std::uint32_t> order;
  Records sorted;
  if (options.target != 0 && tree_options.surface) {
    const Nodes layer = construct(surface.points, surface.cube, tree_options, order, workers, &sorted, true);
    return cluster_by_quadtrees(surface, options.target, layer, sorted,
                                static_cast<std::size_t>(tree_options.threshold), workers);
  }
  const Nodes tree = construct(surface.points, surface.cube, tree_options, order, workers, &sorted);
  if (options.target == 0) return leaves_of(tree.nodes, order, std::vector<float>(tree.nodes.size()), -1);
  const WholeErrors whole(tree.nodes, sorted.all(), workers);
  const LeafCounts counts = LeafCounts::of(tree.nodes, whole.errors());
  return search(surface, options.target, workers, [&](std::size_t aim) {
    return leaves_of(tree.nodes, order, whole.errors(), counts.threshold_for(aim));
  });
}

Clusters cluster_by_grid(const Surface& surface, std::uint32_t cells) {
  Clusters clusters;
  clusters.of.resize(surface.size());
  std::unordered_map<std::uint64_t, std::uint32_t> found;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    std::uint64_t key = 0;
    const Float4 point = surface.point(i);
    for (int k = 0; k < 3; ++k) {
      const float scaled = point[k] * static_cast<float>(cells);
      key = (key << 21) | std::min(static_cast<std::uint32_t>(scaled), cells - 1);
    }
    const auto [at, is_new] = found.try_emplace(key, clusters.count);
    if (is_new) ++clusters.count;
    clusters.of[i] = at->second;
  }
  return clusters;
}

// Returns the grid with the most cells within the target.
Clusters finest_grid(const Surface& surface, std::size_t target, const Workers& workers) {
  Clusters best = cluster_by_grid(surface, 1);
  std::uint32_t cells = 1, too_many = 2;
  const auto try_cells = [&](std::uint32_t count) {
    Clusters clusters = cluster_by_grid(surface, count);
    clusters.set_triangles(spanning(surface.triangles, clusters.of, workers));
    if (size_of(surface, clusters) > target) return false;
    best = std::move(clusters);
    return true;
  };
  while (too_many < most_cells && best.count < surface.size() && try_cells(too_many)) {
    cells = too_many;
    too_many *= 2;
  }
  while (too_many - cells > 1) {
    const std::uint32_t middle = cells + (too_many - cells) / 2;
    (try_cells(middle) ? cells : too_many) = middle;
  }
  return best;
}

}  // namespace

void Clusters::set_triangles(std::vector<std::uint32_t> spanning) {
  irregular = irregular_vertices(spanning, count);
  triangles = without_repeats(std::move(spanning), irregular);
}

Clusters cluster(const Surface& surface, const SimplifyOptions& options, const Workers& workers) {
  if (surface.size() == 0) return {};
  if (options.clustering != Clustering::grid) return cluster_by_tree(surface, options, workers);
  // Clamped below, because it may be infinite.
  const double side = 1 / (double{options.threshold} * surface.cube.diagonal);
  return options.target != 0
             ? finest_grid(surface, options.target, workers)
             : cluster_by_grid(surface,
                               static_cast<std::uint32_t>(std::clamp(std::ceil(side), 1.0, double{most_cells})));
}

}  // namespace glark::vstree
