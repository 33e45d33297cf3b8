// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tells normals from offsets. Programs draw balls as squares: all corners of a square have the position of the middle, and
// an attribute, often called a normal, moves each corner away from it. Outlines also move vertices along normals, but
// these have the length 1. No GL.
#pragma once

#include <algorithm>
#include <span>

#include "glark/core/meshes/overlays.h"

namespace glark::core {

// Nearly all have the length 1, or 0.
inline bool are_directions(std::span<const Point> normals) {
  constexpr float tolerance = 0.1F;
  constexpr std::ptrdiff_t one_of = 20;
  const auto is_other = [](const Point& n) {
    const float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    return square != 0 && !(square > 1 - tolerance && square < 1 + tolerance);
  };
  return one_of * std::count_if(normals.begin(), normals.end(), is_other) <=
         static_cast<std::ptrdiff_t>(normals.size());
}

}  // namespace glark::core
