// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How a scan is sampled: the cells, the size of the micro-clusters, and what may lie in memory at a time.
#pragma once

#include <algorithm>
#include <vector>

#include "glark/clients/stream/sample/grid/cells.h"
#include "glark/clients/stream/sample/tree/cluster_tree.h"

namespace glark::stream {

struct Plan {
  Lattice lattice;
  std::vector<Cell> cells;
  int finer = 0;            // a micro-cluster's side is that of a cube of the lattice, divided by 2^finer
  std::uint32_t least = 1;  // micro-clusters of a leaf
  bool by_error = false;
  bool is_shuffled = false;       // the unfinished cells do not fit into memory
  std::size_t memory = 0;         // of the whole process
  std::size_t open_bytes = 0;     // for unfinished cells, or for the buffers of shuffled points
  std::size_t tree_clusters = 0;  // the most micro-clusters of the trees that are built at a time

  std::array<double, 3> corner(std::size_t cell) const { return lattice.corner(cells[cell].key); }
  double side(std::size_t cell) const { return std::ldexp(lattice.side, static_cast<int>(cells[cell].level)); }
  std::array<double, 3> centre(std::size_t cell) const {
    std::array<double, 3> at = corner(cell);
    for (double& coordinate : at) coordinate += side(cell) / 2;
    return at;
  }
  unsigned bits(std::size_t cell) const { return static_cast<unsigned>(static_cast<int>(cells[cell].level) + finer); }
  // fewer: bits less than bits(cell), where it has too many micro-clusters.
  TreeOptions tree_options(std::size_t cell, bool has_normals, unsigned fewer = 0) const {
    return {has_normals, by_error, std::max(1U, least >> std::min(31U, 2 * fewer)), bits(cell) - fewer, side(cell)};
  }
};

// The plan does not depend on the number of threads. So no more than these trees are built at a time.
inline constexpr std::size_t trees_at_a_time = 4;
// The most occupied cubes that the first pass may count in this memory: a power of two.
std::size_t most_cubes(std::size_t memory);
// Throws Error if the cells alone take more memory than the options allow.
Plan make_plan(const Census& census, const SampleOptions& options);

}  // namespace glark::stream
