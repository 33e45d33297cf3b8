// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The last step of all ranks: one threshold for all cells, and the samples in the order of the single process.
#pragma once

#include "glark/clients/stream/ranks/sample/cell_file.h"
#include "glark/clients/stream/sample/sample_steps.h"

namespace glark::stream {

struct SelectInput {
  const Plan& plan;
  const Shares& shares;
  const TreeStore& trees;               // of the owned cells
  const std::filesystem::path& folder;  // for temporary files
};

// Chooses the threshold by the trees of all cells. cut_of(assembly) does so, on rank 0. Then write(assembly, cut,
// select_cell) is called there, which must ask for the samples of all cells in their order, as Assembly::select() does.
// Rank 0 has a piece of the samples in memory at a time. Throws RanksError, for errors of `write`, too.
using ChooseCut = std::function<Cut(const Assembly& assembly)>;
using WriteSamples = std::function<void(const Assembly& assembly, const Cut& cut, const SelectCell& select_cell)>;
void select_samples(Ranks& ranks, const SelectInput& input, const ChooseCut& cut_of, const WriteSamples& write);

}  // namespace glark::stream
