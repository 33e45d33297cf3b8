// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The positions of a frame, taken over from the caller: checked, and scaled by a power of two so that no coordinate is above 1. What
// is computed of them is then the same at every scale, and neither overflows nor vanishes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glark/clients/qas/float4.h"

namespace glark::qas {

struct Scaled {
  float scale = 1;    // of the caller's space in the scaled one
  float unscale = 1;  // 1 / scale, exactly
};

// Throws Error, before anything is written.
Scaled take_positions(std::span<const float> positions, std::vector<Float4>& to);

// Throws Error unless they are of a point of the triangle.
void check_barycentric(const std::array<float, 3>& barycentric);

}  // namespace glark::qas
