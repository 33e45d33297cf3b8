// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace glark::stream {

struct SamplingMemory {
  std::size_t sampling = 0;  // bytes for it
  std::size_t process = 0;   // bytes for the whole process
};

// How the memory for a sampling on the disk is used.
struct CellPlan {
  std::size_t samples_a_cell = 0;  // at most
  std::size_t cache = 0;           // bytes of the cells that stay in memory
  std::size_t sorting = 0;         // bytes, before there are cells
  std::size_t process = 0;         // bytes of the whole process: near this, what was freed goes back to the system
};

// Throws Error if so many samples, or so many threads, need more: the message tells how much.
CellPlan plan_cells(const SamplingMemory& memory, std::size_t samples, std::size_t channels, std::size_t threads);

}  // namespace glark::stream
