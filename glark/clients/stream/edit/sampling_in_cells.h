// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/stream/edit/sampling.h"

namespace glark::stream {

// read_sampling() for samples that do not fit into memory.
Sampling read_into_cells(const SamplingFiles& files, const SamplingMemory& memory, const common::Workers& workers);

}  // namespace glark::stream
