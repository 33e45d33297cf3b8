// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The normals of an edited sampling, from the motion of its points.
#pragma once

#include <array>
#include <span>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/samples/cells/samples_in_cells.h"
#include "glark/clients/stream/samples/sample_store.h"

namespace glark::stream {

// Sets the normals after the edit: each turns as the nearest samples have moved. Throws Error for a disk that is full or
// cannot be read.
void turn_normals(SamplesInMemory& store, const common::Workers& workers);
void turn_normals(SamplesInCells& store, const common::Workers& workers);

}  // namespace glark::stream
