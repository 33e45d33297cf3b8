// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samplings as files of points.
#pragma once

#include <glark/edit.h>
#include <glark/point_stream.h>

namespace glark::edit {

// The arrays of a sampling, which others own.
struct SamplingView {
  std::span<const double> positions;
  std::span<const float> normals;         // or empty
  std::span<const std::uint8_t> colours;  // or empty
};

// Reads the samples from `first` on. Throws stream::Error.
Sampling read_sampling(const std::filesystem::path& file, std::size_t first = 0);
// Positions have 64 bits, so that nothing is lost. Throws stream::Error.
void write_sampling(const std::filesystem::path& file, const SamplingView& sampling);

}  // namespace glark::edit
