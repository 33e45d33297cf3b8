// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The memory that the unfinished cells of all ranks would take in a single process.
#pragma once

#include <vector>

#include "glark/clients/stream/ranks/ranks.h"
#include "glark/clients/stream/sample/pass/plan.h"

namespace glark::stream {

// A batch of points after which the table of a cell has another size.
struct OpenChange {
  std::uint32_t batch = 0;
  std::int64_t bytes = 0;  // more than after the batch before
};

// Whether the tables of a single process would fit after each of the batches. The changes of all ranks are added: each
// rank checks a range of the batches. All ranks get the same answer. Throws RanksError.
bool fit_in_open_memory(Ranks& ranks, const Plan& plan, std::uint64_t batches, const std::vector<OpenChange>& changes);

}  // namespace glark::stream
