// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sampling before and after its editing.
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/samples/cells/cell_plan.h"
#include "glark/clients/stream/samples/sample_store.h"

namespace glark::stream {

struct Sampling {
  std::array<double, 3> origin{};  // positions of the samples are relative to it
  std::unique_ptr<SampleStore> store;
  std::vector<Channel> channels;  // of the samples' values: those that are new in the edited sampling, or have changed
  bool is_deformed = false;
};

struct SamplingFiles {
  std::filesystem::path from, to;  // before and after the edit
  std::filesystem::path folder;    // for temporary files
};

// Reads both files. The samples of `to` correspond by their order, or by a channel "index". Normals before are those of
// `from`, or estimated. Normals after are turned as the neighbours of each sample are. Samples that take more than
// `memory` are kept in cells on the disk: the bits are the same, but normals cannot be estimated.
// Throws Error if the numbers of samples differ, a coordinate is above 1e18, or an index is out of range or repeated; if
// the memory is too small even for cells; and for a full disk.
Sampling read_sampling(const SamplingFiles& files, const SamplingMemory& memory, const common::Workers& workers);

// The bytes that a sampling takes in memory while it is read, at most; and afterwards.
struct SamplingBytes {
  std::size_t reading = 0, kept = 0;
};
SamplingBytes bytes_in_memory(const SamplingFiles& files);

}  // namespace glark::stream
