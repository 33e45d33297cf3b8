// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/sample/pass/plan.h"
#include "glark/clients/stream/sample/pass/tree_store.h"

namespace glark::stream {

// The micro-clusters of a cell, and by how many bits less than planned they are told apart.
struct SummedCell {
  std::size_t cell = 0;
  std::vector<MicroCluster> clusters;
  unsigned fewer = 0;
};

// Builds the trees of some cells, as many at a time as the memory allows. Empties the cells.
void put_trees(std::span<SummedCell> cells, const Plan& plan, bool has_normals, const common::Workers& workers,
               TreeStore& trees);

}  // namespace glark::stream
