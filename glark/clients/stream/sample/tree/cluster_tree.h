// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The clusters of a cell, from coarse to fine, so that the threshold can be chosen when all cells are known.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/stream/sample/tree/micro_clusters.h"

namespace glark::stream {

// Sums over points and their tangent planes, relative to an origin that the user knows.
struct Shape {
  double count = 0;
  std::array<double, 3> position{}, normal{}, colour{};                          // sums
  std::array<double, 10> quadric{};                                              // as MicroCluster::sums with normals
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};  // the box of the micro-clusters

  void add(const Shape& other);
  // The same about an origin that is moved by `by`.
  Shape moved(const std::array<double, 3>& by) const;
  double radius() const;
  // The point nearest to the planes, within the shape.
  std::array<double, 3> best_point() const;
  // The sum of the squared distances of the point from the planes.
  double error_at(const std::array<double, 3>& point) const;
};

// A cluster that may become a sample. The nodes of a tree stand in preorder.
struct ClusterNode {
  float error = 0;         // no less than the errors of the nodes below
  std::uint32_t size = 1;  // the number of nodes of its subtree, with itself
  std::uint32_t children = 0;
  float count = 0;                  // points
  float square = 0;                 // the sum of the squared distances of its points from the planes
  std::array<float, 3> position{};  // from the centre of the cell
  std::array<float, 3> normal{};    // of unit length, or zero
  std::array<std::uint8_t, 4> colour{};
};

struct ClusterTree {
  std::vector<ClusterNode> nodes;
  Shape shape;  // of the whole cell, relative to its centre
};

struct TreeOptions {
  bool has_normals = true;
  bool by_error = false;    // the error of a node is a root mean square distance; else the sum that a target needs
  std::uint32_t least = 1;  // a node with this many micro-clusters is a leaf
  unsigned bits = 1;        // the cell has 2^bits micro-clusters along an edge
  double side = 1;          // of the cell
};

// The micro-clusters are those of one cell, sorted by key.
ClusterTree cluster_tree(std::span<MicroCluster> clusters, const TreeOptions& options);

// The error of a shape as one cluster. `place`: any number that tells equal shapes apart.
float cluster_error(const Shape& shape, bool by_error, std::uint64_t place);
// Fills a node, except its size and its children.
ClusterNode node_of(const Shape& shape, float error);

}  // namespace glark::stream
