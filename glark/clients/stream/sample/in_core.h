// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/stream/sample/pass/cell_pass.h"

namespace glark::stream {

using CreateWriter = std::function<std::unique_ptr<PointWriter>(const Schema&)>;

// Whether vstree::simplify() of this many points fits in the memory, whatever they fill.
bool fits_in_core(std::uint64_t points, bool has_normals, const SampleOptions& options);
// Samples with vstree::simplify().
SampleReport sample_in_core(BlockSource& source, const SampleOptions& options, const CreateWriter& create);

// The schema of a sampling: positions as the source has them, normals, and red green blue.
Schema sampling_schema(const Schema& source, bool has_colours);

}  // namespace glark::stream
