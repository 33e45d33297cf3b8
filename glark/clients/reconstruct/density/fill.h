// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Fills sparse parts with samples of the surface that the samples there and their normals describe.
#pragma once

#include <span>
#include <vector>

#include "glark/clients/reconstruct/density/neighbours.h"

namespace glark::reconstruct {

// Samples in the unit cube.
struct Filling {
  std::vector<Float4> points, normals;
  std::vector<std::uint8_t> colours;  // [3 * points], if the given samples have colours

  void append(const Filling& other);
};

// Returns about how many samples filling_around() adds.
double count_of_filling(std::span<const std::uint32_t> sparse, const Neighbours& neighbours, float spacing,
                        const Workers& workers);

// Adds samples around the given ones, about `spacing` apart. is_used[entry] is 0 for samples without influence. Each
// new sample is nearer to its given one than to all others that face the same way. New samples lie between given ones,
// not beyond the boundary.
Filling filling_around(std::span<const std::uint32_t> sparse, const Neighbours& neighbours, const PointSet& points,
                       std::span<const std::uint8_t> is_used, float spacing, const Workers& workers);

}  // namespace glark::reconstruct
