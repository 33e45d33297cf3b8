// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The samples in the order of the octree's cells, so that those of a cell of any level follow one another.
#pragma once

#include <glark/reconstruct.h>

#include <array>
#include <vector>

#include "glark/clients/reconstruct/cell_table.h"
#include "glark/clients/vstree/record.h"
#include "glark/clients/workers.h"

namespace glark::vstree {

inline constexpr unsigned cell_levels = 16;  // of the octree here; its keys have three bits for each

// The cell of a point on the last level, and its key: a bit of x, of y and of z in turn.
using CellIndex = std::array<std::int32_t, 3>;
CellIndex cell_of(Float4 point, unsigned level);
std::uint64_t key_of(const CellIndex& cell);
CellIndex cell_of_key(std::uint64_t key);

// The records of a cell, begin .. end - 1, and where it is from another: x + 3 y + 9 z, each 0 to 2.
struct NearCell {
  std::uint32_t begin = 0, end = 0;
  std::uint32_t which = 0;
};

// The non-empty cells of one level.
struct Level {
  unsigned level = 0;
  std::vector<std::uint64_t> keys;
  std::vector<std::uint32_t> begins;  // [keys + 1], of their records
  CellTable table;
  // Of each cell itself and those around it that have samples.
  std::vector<std::uint32_t> around_begins;  // [keys + 1]
  std::vector<NearCell> around;

  float side() const { return 1.0F / static_cast<float>(1U << level); }
  // The number of a cell; CellTable::absent if it has no samples.
  std::uint32_t find(const CellIndex& cell) const;
  // The same of a cell that has no samples itself.
  void add_around(const CellIndex& cell, std::vector<NearCell>& cells) const;
};

struct Octree {
  Cube cube;  // of the root, which holds the bounding box
  std::vector<Record>
      records;  // those with a normal, in the order of the cells; and three more, to be read but not used
  // The finest that transition nodes may have, and coarser ones.
  std::vector<Level> levels;
  float noise = 0;  // as Reconstructed has it, within the cube

  const Level& finest() const { return levels[0]; }
};

Octree sort_samples(const PointSet& points, const ReconstructOptions& options, const Workers& workers);

}  // namespace glark::vstree
