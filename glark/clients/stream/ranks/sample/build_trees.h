// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The trees of the cells that a rank owns, from its file of cells.
#pragma once

#include "glark/clients/stream/ranks/sample/cell_file.h"
#include "glark/clients/stream/sample/pass/cell_pass.h"

namespace glark::stream {

struct BuildInput {
  const Plan& plan;
  const Shares& shares;
  const CellFile& file;
  const PointKind& kind;
  const common::Workers& workers;
  std::uint64_t points = 0;  // of the scan
};

// The file has streamed points. Returns false, on all ranks, if a single process would have found that its unfinished
// cells take more memory than the plan allows: then the points must be sent as shuffled ones. Throws RanksError.
bool build_streamed_trees(Ranks& ranks, const BuildInput& input, TreeStore& trees);
void build_shuffled_trees(Ranks& ranks, const BuildInput& input, TreeStore& trees);

}  // namespace glark::stream
