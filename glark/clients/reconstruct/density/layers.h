// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Layers of a surface that face the same way and lie so near to each other that the planes of one would reach the
// other, as nested bowls do.
#pragma once

#include <vector>

#include "glark/clients/reconstruct/samples/octree.h"

namespace glark::reconstruct {

// Returns groups of the samples' indices, each to be reconstructed on its own, so that layers do not mix. Only layers
// that are not connected to each other get different groups. Empty: all samples are one group.
std::vector<std::vector<std::uint32_t>> layers_of(const PointSet& points, const SortedSamples& sorted,
                                                  const Workers& workers);

}  // namespace glark::reconstruct
