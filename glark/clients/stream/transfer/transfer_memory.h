// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/stream/edit/sampling.h"

namespace glark::stream {

// How a transfer divides its memory.
struct TransferMemory {
  // memory: bytes for the whole process. Throws Error if they are too few.
  TransferMemory(std::size_t memory, const SamplingFiles& files, const common::Workers& workers);

  std::size_t sampling = 0;  // bytes for the sampling: all of it, or the cells of it that are used
  std::size_t batch = 0;     // bytes for the records that are edited at a time
};

}  // namespace glark::stream
