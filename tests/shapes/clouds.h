// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clouds of samples that scanners and their programs make of a statue. Each differs with its seed.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/shapes/solids.h"

namespace glark::shapes {

struct Cloud {
  std::vector<float> positions, normals;  // [3 * samples]
  std::size_t size() const { return positions.size() / 3; }
};

struct CloudOptions {
  std::size_t samples = 100000;
  double density_ratio = 1;  // samples an area at the feet, relative to the head; it changes exponentially between
  double noise = 0;          // the standard deviation of the positions along the normals
  double outliers = 0;       // their share of the samples; they fill the box evenly, with random normals
  double layers = 0;         // half of the samples are shifted by this distance, as a second scan
  double hole = 0;           // the radius of three holes
};

Cloud cloud_of(const Statue& statue, unsigned seed, const CloudOptions& options);

// Samples of a surface with so much noise that there is no surface any more: a ball of fog.
Cloud fog(unsigned seed, std::size_t samples);

}  // namespace glark::shapes
