// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clusters of a volume-surface tree for a target. Each transition node has a grid instead of a quadtree. The cells of
// the grid hold sums over their samples. The sums of quadrants and of pairs of quadrants are added from the finest
// level upwards. So no sample is moved, and no quadtree node is made.
#pragma once

#include <glark/vstree.h>

#include <deque>
#include <vector>

#include "glark/clients/vstree/simplify/sheets/boundary.h"
#include "glark/clients/vstree/tree/construction.h"
#include "glark/clients/vstree/tree/prune.h"

namespace glark::vstree {

class Quadtrees {
 public:
  // layer, sorted: a tree that ends at the transition layer, and its records. samples: the target number of samples per
  // cell. With 1, samples at different positions get different cells. boundary: null if there is none.
  Quadtrees(const Nodes& layer, std::span<const Record> sorted, std::size_t samples, const BoundaryPlanes* boundary,
            const Workers& workers);

  // Sets the cluster of each sample, by its index. Returns the number of clusters: at most `most`, but at least one.
  std::uint32_t cluster(std::size_t most, std::vector<std::uint32_t>& of) const;

 private:
  struct Grid {
    LocalFrame frame;
    std::span<const Record> records;
    float most_error;          // the error of the part that the grid divides: an upper limit for its parts
    std::uint32_t parent;      // a node of the layer, or the part that the grid divides
    std::uint32_t first_part;  // the first of its finest cells
    std::uint32_t first_quad;
    unsigned levels;
  };
  // Four cells, or four quads of the next finer level.
  struct Quad {
    float error = 0;          // the error as one cluster; no less than the errors below
    float pairs[2] = {};      // the errors as two clusters
    std::uint8_t first = 3;   // the two of the four that are the first pair: 3 or 5, as bits
    std::uint8_t filled = 0;  // the quarters that have samples, as bits

    bool has(unsigned which) const { return (filled & which) != 0; }
    bool has_all(unsigned which) const { return (filled & which) == which; }
    std::uint8_t second() const { return static_cast<std::uint8_t>(15 - first); }
  };
  // The samples of cells that have too many samples, and the grids that divide these cells.
  struct Rest {
    std::vector<Record> records;
    std::vector<Grid> grids;  // the grids over these samples
  };
  struct Sums;

  void add_grid(Grid grid);
  Rest fill(const Grid& grid, Sums& whole);
  Rest divide(const Grid& grid, std::span<const Sums> cells) const;
  void put_together(const Grid& grid, std::span<Sums> cells);
  void find_volume_errors(std::span<const Record> sorted, std::span<const Sums> wholes);
  LeafCounts leaf_counts() const;
  void cluster(const Grid& grid, float threshold, std::uint32_t& count, std::vector<std::uint32_t>& of_part) const;

  const std::vector<Node>& nodes_;
  const BoundaryPlanes* boundary_;
  const std::size_t samples_, most_samples_;  // per cell: the target and the maximum
  std::vector<Grid> grids_;                   // those of the transition nodes first, in their order
  std::size_t transition_nodes_ = 0;
  std::deque<Rest> rests_;
  std::vector<Quad> quads_;                // the coarsest of each grid first
  std::vector<float> volume_errors_;       // for each node, transition nodes included
  std::vector<std::uint32_t> part_of_;     // for each sample, by its index
  std::vector<std::uint8_t> kinds_;        // for each part
  std::vector<std::uint32_t> leaf_parts_;  // the parts of octree leaves; `none` for other nodes
};

}  // namespace glark::vstree
