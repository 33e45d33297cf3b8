// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples sorted by the octree's cells, so that the samples of a cell of any level follow one another.
#pragma once

#include <glark/reconstruct.h>

#include <array>
#include <vector>

#include "glark/clients/common/points/record.h"
#include "glark/clients/common/workers.h"
#include "glark/clients/reconstruct/samples/cell_blocks.h"

namespace glark::reconstruct {

using namespace common;  // Float4, records and workers
using vstree::none;
using vstree::PointSet;

inline constexpr unsigned cell_levels = 16;  // the levels of this octree; keys have three bits for each level

// Returns the cell of a point, or the nearest cell for a point outside the root.
CellIndex cell_of(Float4 point, unsigned level);

// The non-empty cells of one level.
struct Level {
  unsigned level = 0;
  std::vector<std::uint64_t> keys;
  std::vector<std::uint32_t> begins;  // [keys + 1], the first records of the cells
  CellBlocks blocks;

  float side() const { return 1.0F / static_cast<float>(1U << level); }
};

struct Octree {
  Cube cube;  // the root, which holds the bounding box
  // The samples that have a normal, in the order of the cells. The fourth number of a position is the packed colour.
  std::vector<Record> records;
  bool has_colours = false;
  // The finest level that transition nodes may have, then coarser ones.
  std::vector<Level> levels;
  float noise = 0;  // as in Reconstructed, relative to the cube

  const Level& finest() const { return levels[0]; }
};

// A sample in the order of the octree's cells.
struct Entry {
  std::uint64_t key;
  std::uint32_t index;
};

// The samples that have a normal, by the cells of the bounding cube.
struct SortedSamples {
  Cube cube;
  std::vector<Entry> entries;
};

SortedSamples sort_by_cells(const PointSet& points, const Workers& workers);

// The cells of a level that have samples. The entries are sorted.
Level finest_level(const std::vector<Entry>& entries, unsigned level);
Level coarser(const Level& fine);

Octree octree_of(const PointSet& points, SortedSamples sorted, const ReconstructOptions& options,
                 const Workers& workers);

}  // namespace glark::reconstruct
