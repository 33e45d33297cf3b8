// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks the positions of a frame and scales them by a power of two, so that no coordinate is above 1. The results are
// then the same at every scale, and neither overflow nor vanish.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glark/clients/qas/float4.h"

namespace glark::qas {

struct Scaled {
  float scale = 1;    // from the caller's space to the scaled space
  float unscale = 1;  // 1 / scale, exactly
};

// Throws Error before it writes anything.
Scaled take_positions(std::span<const float> positions, std::vector<Float4>& to);

// Throws Error unless the coordinates belong to a point of the triangle.
void check_barycentric(const std::array<float, 3>& barycentric);

}  // namespace glark::qas
