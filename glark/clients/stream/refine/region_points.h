// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The points of a scan that belong to a region, and as much of the scan as has to be read for them.
#pragma once

#include <glark/stream.h>

#include "glark/clients/stream/edit/sampling.h"

namespace glark::stream {

// Which samples are in the region. `after` has the positions after the edit. Throws Error if there are none, or if the
// channel is missing.
std::vector<bool> samples_in(const Region& region, const Sampling& sampling, const std::string& file);

struct RegionPoints {
  Schema schema;
  std::vector<double> positions, channels;
  std::vector<float> normals;
  std::uint64_t samples = 0;  // points of the region that are samples already, and left out
  std::uint64_t points_read = 0;
};

// Reads the points whose nearest sample is in the region. Throws Error if they take more than `memory` bytes, or if a
// cell has not as many points as the index says.
RegionPoints read_region(const std::filesystem::path& large, const CellIndex& index, const Sampling& sampling,
                         const std::vector<bool>& is_inside, std::size_t memory, const common::Workers& workers);

}  // namespace glark::stream
