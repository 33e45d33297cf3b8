// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The shares of the ranks: each counts some of the points, and owns some of the cells.
#pragma once

#include <vector>

#include "glark/clients/stream/ranks/range.h"
#include "glark/clients/stream/sample/pass/plan.h"

namespace glark::stream {

// The first pass of all ranks: the census of the scan, on all ranks, and that of this rank's range.
struct RanksCensus {
  Census all;
  std::vector<Cube> own;  // the cubes of all.level that have points of this rank, sorted by key
  RankRange range;        // of this rank's points
};

// Each rank counts its range; the counts are added along a binomial tree. Throws RanksError.
RanksCensus take_census(Ranks& ranks, BlockSource& source, const CensusOptions& options, const Progress& progress);

// The cells in the order of their first points, dealt so that all ranks own about as many points. So the owner of a cell
// is mostly the rank that reads its points. Returns the owner of each cell.
std::vector<std::uint32_t> deal_cells(const std::vector<Cell>& cells, std::size_t ranks);

// The points of a rank in each cell: [cells].
std::vector<std::uint64_t> counts_of(const std::vector<Cell>& cells, const std::vector<Cube>& cubes);

}  // namespace glark::stream
