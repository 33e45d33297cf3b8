// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The spacing and the noise of samples, measured over the cells of an octree.
#pragma once

#include <array>
#include <vector>

#include "glark/clients/reconstruct/samples/octree.h"

namespace glark::reconstruct {

// The fewest samples of a cell that show its noise.
inline constexpr std::size_t least_samples = 8;

// For each level, the number of cells that have samples. On the last level, this is the number of places with samples.
struct Occupancy {
  std::array<std::size_t, cell_levels + 1> cells{};
  double samples() const { return static_cast<double>(cells[cell_levels]); }
  double samples_a_cell(unsigned level) const { return samples() / static_cast<double>(cells[level]); }
};

Occupancy occupancy_of(const std::vector<Entry>& entries);

// Returns the side of cells that have about `aim` samples each, within the unit cube.
double side_for(const Occupancy& occupancy, double aim);

// Returns the median noise of the samples of a cell, within the unit cube, over the cells of the level with at least
// `least_samples`.
double noise_of(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries, unsigned level);

// Returns the share of the cells of the level that have two layers which face the same way. The layers are farther apart
// than their samples.
double share_of_layers(const PointSet& points, const Cube& cube, const std::vector<Entry>& entries, unsigned level);

// The level whose cells have about twice as many samples.
unsigned level_for_noise(const Occupancy& occupancy);

}  // namespace glark::reconstruct
