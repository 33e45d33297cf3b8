// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The steps of a sampling that are the same for one process and for several.
#pragma once

#include <glark/stream.h>

#include "glark/clients/stream/sample/assembly.h"
#include "glark/clients/stream/sample/in_core.h"

namespace glark::stream {

// Throws Error for options out of range.
void require_valid(const SampleOptions& options);
ReadOptions reading_options(const SampleOptions& options);
// Whether all points are sampled at once. Throws Error for a source that is known to be empty.
bool is_sampled_in_core(const BlockSource& source, const SampleOptions& options);

// The lattice and the limits of the first pass.
CensusOptions counting_options(const Source& source, const SampleOptions& options, std::size_t threads);
// Throws Error for a scan without a point that has finite coordinates.
void require_points(const Census& census, const std::string& source);

Cut cut_of(const Assembly& assembly, const Census& census, const SampleOptions& options);
// The report before the samples are chosen.
SampleReport report_of(const Census& census, const Plan& plan);

// Writes the samples to a new file, and notes in `report` which cells have them. source: the schema of the scan.
void write_samples(const Assembly& assembly, const Cut& cut, const SelectCell& select_cell, const Schema& source,
                   const SampleOptions& options, const CreateWriter& create, SampleReport& report);

}  // namespace glark::stream
