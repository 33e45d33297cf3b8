// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/clusters.h"

#include <algorithm>
#include <unordered_map>

#include "glark/clients/vstree/construction.h"
#include "glark/clients/vstree/prune.h"

namespace glark::vstree {
namespace {

constexpr int most_searches = 6;
constexpr std::size_t parts_a_cluster = 3;  // of the tree from which clusters are put together

// Triangles, or points of a set, that clusters leave.
std::size_t size_of(const Surface& surface, const Clusters& clusters) {
  return surface.triangles.empty() ? clusters.count : spanning_triangles(surface.triangles, clusters.of);
}

// `make(k)` gives clusters, about k of them; returns those with the most triangles, or points, within the target.
template <typename Make>
Clusters search(const Surface& surface, std::size_t target, const Make& make) {
  const bool points = surface.triangles.empty();
  Clusters best;
  std::size_t best_size = 0;
  std::size_t aim = points ? target : std::max<std::size_t>(target / 2, 1);
  for (int i = 0; i < most_searches; ++i) {
    Clusters clusters = make(aim);
    const std::size_t size = size_of(surface, clusters);
    const bool fits = size <= target;
    if (fits && (best.of.empty() || size > best_size)) {
      best = std::move(clusters);
      best_size = size;
    }
    if (fits && (size + target / 200 >= target || aim >= surface.points.size())) break;
    const double factor = static_cast<double>(target) * 0.998 / static_cast<double>(std::max<std::size_t>(size, 1));
    aim = static_cast<std::size_t>(static_cast<double>(aim) * std::clamp(factor, 0.25, 4.0));
    if (aim == 0) break;
  }
  if (best.of.empty()) best = make(1);
  return best;
}

// Leaves that come from nodes whose error is small enough, with the shapes of the nodes if they are known.
Clusters leaves_of(std::span<const Node> nodes, std::span<const std::uint32_t> order, std::span<const float> errors,
                   float threshold, std::span<const Shape> shapes) {
  Clusters clusters;
  clusters.of.resize(order.size());
  std::vector<std::uint32_t> cluster_of(nodes.size(), none);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (cluster_of[i] == none && (node.is_leaf() || errors[i] <= threshold)) {
      cluster_of[i] = clusters.count++;
      if (!shapes.empty()) clusters.shapes.push_back(shapes[i]);
      for (std::uint32_t k = node.begin; k < node.end; ++k) clusters.of[order[k]] = cluster_of[i];
    }
    if (node.is_leaf() || cluster_of[i] == none) continue;
    for (std::uint32_t k = 0; k < node.child_count(); ++k) cluster_of[node.first_child + k] = cluster_of[i];
  }
  return clusters;
}

// Of each node, its leaves' samples and triangles.
std::vector<Shape> node_shapes(const Surface& surface, std::span<const Node> nodes,
                               std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> groups(order.size());
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_leaf()) continue;
    for (std::uint32_t k = nodes[i].begin; k < nodes[i].end; ++k) groups[order[k]] = i;
  }
  std::vector<Shape> shapes = shapes_of(surface, groups, nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].is_leaf()) continue;
    const std::span<const Shape> children{&shapes[nodes[i].first_child], nodes[i].child_count()};
    Shape shape;
    for (const Shape& child : children) shape.sum += child.sum;
    for (const Shape& child : children) {
      const Float4 apart = shape.centroid() - child.centroid();
      shape.quadric.add(child.quadric.moved(apart));
      shape.radius = std::max(shape.radius, child.radius + std::sqrt(dot(apart, apart)));
    }
    shapes[i] = shape;
  }
  return shapes;
}

// Of each node the squared distance of its best point from its planes, by their weight in all, and no less than that of any node
// below it. Not the mean: dividing goes on where it gains most for the whole surface. A little of the extent counts too, so that what is
// flat is divided evenly.
std::vector<float> whole_errors(std::span<const Node> nodes, std::span<const Shape> shapes) {
  std::vector<float> errors(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const Shape& shape = shapes[i];
    const float extent = shape.radius * shape.radius * (shape.quadric.weight() + 1e-12F * shape.sum[3]);
    errors[i] = shape.quadric.error_at(shape.best_step()) + 1e-6F * extent;
    const std::size_t children = nodes[i].is_leaf() ? 0 : nodes[i].child_count();
    for (std::size_t k = 0; k < children; ++k) errors[i] = std::max(errors[i], errors[nodes[i].first_child + k]);
  }
  return errors;
}

Clusters cluster_by_tree(const Surface& surface, const SimplifyOptions& options, const Workers& workers) {
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
        static_cast<float>(std::max<std::size_t>(1, surface.points.size() / (parts_a_cluster * clusters)));
  }
  std::vector<std::uint32_t> order;
  const Nodes tree = construct(surface.points, surface.normals, tree_options, surface.cube.diagonal, order, workers);
  if (options.target == 0) return leaves_of(tree.nodes, order, std::vector<float>(tree.nodes.size()), -1, {});
  const std::vector<Shape> shapes = node_shapes(surface, tree.nodes, order);
  const std::vector<float> errors = whole_errors(tree.nodes, shapes);
  const LeafCounts counts(tree.nodes, errors);
  return search(surface, options.target, [&](std::size_t aim) {
    return leaves_of(tree.nodes, order, errors, counts.threshold_for(aim), shapes);
  });
}

Clusters cluster_by_grid(const Surface& surface, std::uint32_t cells) {
  Clusters clusters;
  clusters.of.resize(surface.points.size());
  std::unordered_map<std::uint64_t, std::uint32_t> found;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      const float scaled = surface.points[i][k] * static_cast<float>(cells);
      key = (key << 21) | std::min(static_cast<std::uint32_t>(scaled), cells - 1);
    }
    const auto [at, is_new] = found.try_emplace(key, clusters.count);
    if (is_new) ++clusters.count;
    clusters.of[i] = at->second;
  }
  return clusters;
}

constexpr std::uint32_t most_cells = (1 << 21) - 1;  // a side, so that three fit a key

// With the most cells that keep the target.
Clusters finest_grid(const Surface& surface, std::size_t target) {
  Clusters best = cluster_by_grid(surface, 1);
  std::uint32_t cells = 1, too_many = 2;
  const auto try_cells = [&](std::uint32_t count) {
    Clusters clusters = cluster_by_grid(surface, count);
    if (size_of(surface, clusters) > target) return false;
    best = std::move(clusters);
    return true;
  };
  while (too_many < most_cells && best.count < surface.points.size() && try_cells(too_many)) {
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

Clusters cluster(const Surface& surface, const SimplifyOptions& options, const Workers& workers) {
  if (surface.points.empty()) return {};
  if (options.clustering != Clustering::grid) return cluster_by_tree(surface, options, workers);
  if (options.target != 0) return finest_grid(surface, options.target);
  const double side = 1 / (double{options.threshold} * surface.cube.diagonal);  // of infinitely many the most
  return cluster_by_grid(surface, static_cast<std::uint32_t>(std::clamp(std::ceil(side), 1.0, double{most_cells})));
}

}  // namespace glark::vstree
