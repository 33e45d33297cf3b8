// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace glark::surfel {

// Returns the point spacing at a triangle, from the spacings of its three points. The longest edge of the triangle may
// be Options::reach times this.
inline float triangle_spacing(float a, float b, float c) {
  const float median = std::max(std::min(a, b), std::min(std::max(a, b), c));
  constexpr float most_ratio = 3;  // two isolated points get no triangle with a point of a dense region
  return std::min(median, most_ratio * std::min({a, b, c}));
}

}  // namespace glark::surfel
