// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sampling before and after its editing.
#pragma once

#include <glark/stream.h>

#include <filesystem>
#include <vector>

#include "glark/clients/common/workers.h"
#include "glark/clients/stream/transfer/sample_index.h"
#include "glark/clients/stream/transfer/samples.h"

namespace glark::stream {

struct Sampling {
  std::array<double, 3> origin{};  // positions of the samples are relative to it
  Samples samples;
  std::vector<Channel> channels;  // of the samples' values: those that are new in the edited sampling, or have changed
  bool is_deformed = false;
};

// Reads both files. The samples of `to` correspond by their order, or by a channel "index". Normals before are those of
// `from`, or estimated. Normals after are turned as the neighbours of each sample are.
// Throws Error if the numbers of samples differ, a coordinate is above 1e18, or an index is out of range or repeated.
Sampling read_sampling(const std::filesystem::path& from, const std::filesystem::path& to,
                       const common::Workers& workers);

}  // namespace glark::stream
