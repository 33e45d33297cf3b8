// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// When the unfinished cells take more memory than the plan allows. Then the points go through a file of cells, which
// rounds their numbers. So this decides about bits of the result.
#pragma once

#include "glark/clients/stream/sample/pass/plan.h"

namespace glark::stream {

// The points that are read between two checks: a power of two.
std::size_t batch_size(const Plan& plan);

// bytes: of the tables of the unfinished cells, after so many batches. The tables of some cells grow for a while before
// others are complete, so the usual limit is checked now and then only.
bool fits_in_open_memory(const Plan& plan, std::size_t bytes, std::uint64_t batches);

}  // namespace glark::stream
