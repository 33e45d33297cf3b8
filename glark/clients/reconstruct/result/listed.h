// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A mesh with the list of samples that are on no surface.
#pragma once

#include <glark/reconstruct.h>

#include <cstdint>
#include <vector>

namespace glark::reconstruct {

struct Listed {
  Reconstructed mesh;
  std::vector<std::uint32_t> outliers;  // the indices of samples, in ascending order
};

// The same as reconstruct(), which gives the number of outliers alone.
Listed reconstruct_and_list(const vstree::PointSet& points, const ReconstructOptions& options);

}  // namespace glark::reconstruct
