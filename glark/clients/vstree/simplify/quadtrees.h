// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clusters of a volume-surface tree for a target. Below each transition node is a grid whose cells sum up what their samples say; quadrants
// and pairs of quadrants are put together from the finest upwards. So no sample is moved, and no node of a quadtree is made.
#pragma once

#include <glark/vstree.h>

#include <deque>
#include <vector>

#include "glark/clients/vstree/tree/construction.h"
#include "glark/clients/vstree/tree/prune.h"

namespace glark::vstree {

class Quadtrees {
 public:
  // layer: as from construct_layer(), with its records; samples: of a cell, aimed at; 1: each is alone in one as far as places differ.
  Quadtrees(const Nodes& layer, std::span<const Record> sorted, std::size_t samples, const Workers& workers);

  // Gives each sample, by its index, its cluster; returns how many there are: no more than `most`, but one at least.
  std::uint32_t cluster(std::size_t most, std::vector<std::uint32_t>& of) const;

 private:
  struct Grid {
    LocalFrame frame;
    std::span<const Record> records;
    float most_error;          // of what it is within: no part has more
    std::uint32_t parent;      // a node of the layer, or the part that it divides
    std::uint32_t first_part;  // its finest cells
    std::uint32_t first_quad;
    unsigned levels;
  };
  // Four cells, or quads of the next finer level.
  struct Quad {
    float error = 0;          // as one cluster, no less than below
    float pairs[2] = {};      // as two
    std::uint8_t first = 3;   // which two of the four are the first pair: 3 or 5, as bits
    std::uint8_t filled = 0;  // which of the four have samples

    bool has(unsigned which) const { return (filled & which) != 0; }
    bool has_all(unsigned which) const { return (filled & which) == which; }
    std::uint8_t second() const { return static_cast<std::uint8_t>(15 - first); }
  };
  // What a grid has too many samples in for one cell.
  struct Rest {
    std::vector<Record> records;
    std::vector<Grid> grids;  // of these
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
  const std::size_t samples_, most_samples_;  // of a cell: aimed at, and possible
  std::vector<Grid> grids_;                   // those of transition nodes first, in their order
  std::size_t transition_nodes_ = 0;
  std::deque<Rest> rests_;
  std::vector<Quad> quads_;                // of each grid the coarsest first
  std::vector<float> volume_errors_;       // of the nodes, transition nodes included
  std::vector<std::uint32_t> part_of_;     // of the samples, by index
  std::vector<std::uint8_t> kinds_;        // of the parts
  std::vector<std::uint32_t> leaf_parts_;  // of the nodes that are leaves of the octree, `none` for others
};

}  // namespace glark::vstree
