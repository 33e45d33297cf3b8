// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

// Points that lie evenly on the unit sphere. A normal of this sphere equals its point.
inline std::vector<float> sphere_points(int count) {
  std::vector<float> positions;
  for (int i = 0; i < count; ++i) {
    const float z = 1 - (2 * static_cast<float>(i) + 1) / static_cast<float>(count);
    const float radius = std::sqrt(1 - z * z);
    const float turn = 2.39996323F * static_cast<float>(i);
    positions.insert(positions.end(), {radius * std::cos(turn), radius * std::sin(turn), z});
  }
  return positions;
}
