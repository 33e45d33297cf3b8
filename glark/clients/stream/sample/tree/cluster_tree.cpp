// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/tree/cluster_tree.h"

#include <glark/vstree.h>

#include <algorithm>
#include <cmath>

#include "glark/clients/stream/sample/grid/lattice.h"
#include "glark/clients/stream/sample/tree/plane_normals.h"

namespace glark::stream {
namespace {

using Point = std::array<double, 3>;

constexpr double flat_share = 1e-6;  // the share of the extent in an error, so that flat parts are divided evenly

std::array<double, 3> product(const std::array<double, 10>& a, const Point& x) {
  return {a[0] * x[0] + a[3] * x[1] + a[5] * x[2], a[3] * x[0] + a[1] * x[1] + a[4] * x[2],
          a[5] * x[0] + a[4] * x[1] + a[2] * x[2]};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Builds the nodes from a volume-surface tree over the micro-clusters.
class NodeBuilder {
 public:
  NodeBuilder(const vstree::Tree& tree, std::span<const Shape> shapes, const TreeOptions& options)
      : tree_(tree), shapes_(shapes), options_(options) {}

  Shape build(std::uint32_t index, std::vector<ClusterNode>& nodes) {
    const vstree::Node& node = tree_.nodes()[index];
    if (!node.is_leaf() && node.child_count() == 1) return build(node.first_child, nodes);
    const std::size_t slot = nodes.size();
    nodes.push_back({});
    Shape shape;
    float error = 0;
    if (node.is_leaf())
      for (const std::uint32_t sample : tree_.samples(node)) shape.add(shapes_[sample]);
    else
      for (std::uint32_t k = 0; k < node.child_count(); ++k) {
        const std::size_t child = nodes.size();
        shape.add(build(node.first_child + k, nodes));
        error = std::max(error, nodes[child].error);
      }
    error = std::max(error, cluster_error(shape, options_.by_error, index));
    nodes[slot] = node_of(shape, error);
    nodes[slot].size = static_cast<std::uint32_t>(nodes.size() - slot);
    nodes[slot].children = node.is_leaf() ? 0 : node.child_count();
    return shape;
  }

 private:
  const vstree::Tree& tree_;
  std::span<const Shape> shapes_;
  const TreeOptions& options_;
};

Shape shape_of(const MicroCluster& cluster, const Point& centre, double half_side) {
  Shape shape;
  shape.count = cluster.count;
  for (std::size_t k = 0; k < 3; ++k) {
    shape.position[k] = cluster.position[k];
    shape.normal[k] = cluster.normal[k];
    shape.colour[k] = cluster.colour[k];
    shape.low[k] = -half_side;
    shape.high[k] = half_side;
  }
  std::copy(cluster.sums.begin(), cluster.sums.end(), shape.quadric.begin());
  if (cluster.count == 1)
    for (std::size_t k = 0; k < 3; ++k) shape.low[k] = shape.high[k] = cluster.position[k];
  return shape.moved(centre);
}

}  // namespace

void Shape::add(const Shape& other) {
  count += other.count;
  for (std::size_t k = 0; k < 3; ++k) {
    position[k] += other.position[k];
    normal[k] += other.normal[k];
    colour[k] += other.colour[k];
    low[k] = std::min(low[k], other.low[k]);
    high[k] = std::max(high[k], other.high[k]);
  }
  for (std::size_t k = 0; k < quadric.size(); ++k) quadric[k] += other.quadric[k];
}

// A point x becomes x + by. The plane n x + d = 0 becomes n x + d - n by = 0.
Shape Shape::moved(const Point& by) const {
  Shape result = *this;
  const Point turned = product(quadric, by);
  const Point offsets{quadric[6], quadric[7], quadric[8]};
  for (std::size_t k = 0; k < 3; ++k) {
    result.position[k] += count * by[k];
    result.low[k] += by[k];
    result.high[k] += by[k];
    result.quadric[6 + k] -= turned[k];
  }
  result.quadric[9] += dot(turned, by) - 2 * dot(offsets, by);
  return result;
}

double Shape::radius() const { return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2; }

double Shape::error_at(const Point& x) const {
  const Point ax = product(quadric, x);
  return std::max(0.0, dot(ax, x) + 2 * (quadric[6] * x[0] + quadric[7] * x[1] + quadric[8] * x[2]) + quadric[9]);
}

// Planes may leave some directions open. A small multiple of the identity keeps the point near the centroid there.
std::array<double, 3> Shape::best_point() const {
  Point c{position[0] / count, position[1] / count, position[2] / count};
  const auto& a = quadric;
  const double hold = 1e-4 * (a[0] + a[1] + a[2]);
  if (!(hold > 0)) return c;
  const Point turned = product(a, c);
  const Point b{turned[0] + a[6], turned[1] + a[7], turned[2] + a[8]};
  const double xx = a[0] + hold, yy = a[1] + hold, zz = a[2] + hold, xy = a[3], yz = a[4], xz = a[5];
  const double c_xx = yy * zz - yz * yz, c_xy = xz * yz - xy * zz, c_xz = xy * yz - xz * yy;
  const double c_yy = xx * zz - xz * xz, c_yz = xy * xz - xx * yz, c_zz = xx * yy - xy * xy;
  const double scale = -1 / (xx * c_xx + xy * c_xy + xz * c_xz);
  Point step{scale * (c_xx * b[0] + c_xy * b[1] + c_xz * b[2]), scale * (c_xy * b[0] + c_yy * b[1] + c_yz * b[2]),
             scale * (c_xz * b[0] + c_yz * b[1] + c_zz * b[2])};
  const double length = std::sqrt(dot(step, step)), most = 0.75 * radius();
  const double share = length > most ? most / length : 1;
  for (std::size_t k = 0; k < 3; ++k) c[k] += share * step[k];
  return c;
}

// A factor from 1 to 2 divides some of several equal flat clusters before others, so that a target can be met.
float cluster_error(const Shape& shape, bool by_error, std::uint64_t place) {
  const double square = shape.error_at(shape.best_point());
  if (by_error) return static_cast<float>(std::sqrt(square / shape.count));
  const double weight = shape.quadric[0] + shape.quadric[1] + shape.quadric[2] + 1e-12 * shape.count;
  const double uneven = 1 + static_cast<double>((place * 0x9E3779B97F4A7C15U) >> 40) * 0x1p-24;
  return static_cast<float>(square + flat_share * shape.radius() * shape.radius() * weight * uneven);
}

ClusterNode node_of(const Shape& shape, float error) {
  ClusterNode node;
  const Point best = shape.best_point();
  node.error = error;
  node.count = static_cast<float>(shape.count);
  node.square = static_cast<float>(shape.error_at(best));
  const double length = std::sqrt(dot(shape.normal, shape.normal));
  for (std::size_t k = 0; k < 3; ++k) {
    node.position[k] = static_cast<float>(best[k]);
    node.normal[k] = length > 0 ? static_cast<float>(shape.normal[k] / length) : 0;
    node.colour[k] = static_cast<std::uint8_t>(std::lround(std::clamp(shape.colour[k] / shape.count, 0.0, 255.0)));
  }
  return node;
}

ClusterTree cluster_tree(std::span<MicroCluster> clusters, const TreeOptions& options) {
  if (!options.has_normals) find_plane_normals(clusters, options.bits, options.side);
  const double small = std::ldexp(options.side, -static_cast<int>(options.bits));
  std::vector<Shape> shapes;
  std::vector<float> positions, normals;
  shapes.reserve(clusters.size());
  for (const MicroCluster& cluster : clusters) {
    Point centre{};
    for (unsigned k = 0; k < 3; ++k)
      centre[k] = (gather_third_bits(std::uint64_t{cluster.key} >> k) + 0.5) * small - options.side / 2;
    shapes.push_back(shape_of(cluster, centre, small / 2));
    for (std::size_t k = 0; k < 3; ++k) {
      positions.push_back(static_cast<float>(shapes.back().position[k] / shapes.back().count));
      normals.push_back(cluster.normal[k]);
    }
  }
  vstree::Options tree_options;
  tree_options.metric = vstree::Metric::density;
  tree_options.threshold = static_cast<float>(options.least);
  tree_options.threads = 1;
  const vstree::Tree tree({.positions = positions, .normals = normals}, tree_options);
  ClusterTree result;
  NodeBuilder builder(tree, shapes, options);
  result.shape = builder.build(0, result.nodes);
  return result;
}

}  // namespace glark::stream
