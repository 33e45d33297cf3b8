// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The nearest neighbours of samples, found by the cells of an octree.
#pragma once

#include <vector>

#include "glark/clients/reconstruct/samples/spacing.h"

namespace glark::reconstruct {

// Samples in the unit cube, in the order of their cells.
class Neighbours {
 public:
  struct Near {
    float square;  // of the distance
    std::uint32_t entry;
    auto operator<=>(const Near&) const = default;
  };

  // All arguments must outlive this object.
  Neighbours(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries);

  std::size_t size() const { return entries_.size(); }
  Float4 point(std::uint32_t entry) const { return cube_.inside(&points_.positions[3 * index_of(entry)]); }
  Float4 normal(std::uint32_t entry) const { return without_fourth(unit_normal_of(entry)); }
  std::size_t index_of(std::uint32_t entry) const { return entries_[entry].index; }
  // Most samples have several others in their cell of this level.
  const Level& finest() const { return levels_.front(); }

  // Sets `out` to the nearest neighbours of a sample, the nearest first. Samples at the same place are left out, and of
  // several samples at another place, one counts. The neighbours are about the nearest: of those beyond one cell of a
  // level, some may be missing.
  void find(std::uint32_t entry, std::size_t count, std::vector<Near>& out) const;

  // The octree's levels: 0 is the finest, levels() - 1 is the root.
  std::size_t levels() const { return levels_.size(); }
  // Returns the coarsest level whose cells are not wider than `side`, or the finest level.
  std::size_t level_for(float side) const;
  // Sets `out` to one sample of each cell around a sample, up to three cells away, the nearest first. So dense parts do
  // not hide sparse ones.
  void find_one_a_cell(std::uint32_t entry, std::size_t level, std::vector<Near>& out) const;

 private:
  std::uint32_t last_alike(std::uint32_t entry, std::uint32_t end) const;

  Float4 unit_normal_of(std::uint32_t entry) const;

  const PointSet& points_;
  const Cube& cube_;
  const std::vector<Entry>& entries_;
  std::vector<Level> levels_;  // the finest first, down to the root
};

// The cells around a cell, up to `away` cells away, within the root.
CellBox cells_around(const CellIndex& cell, unsigned level, std::int32_t away = 1);

}  // namespace glark::reconstruct
