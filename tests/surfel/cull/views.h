// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Matrices of views, for tests of culling.
#pragma once

#include <array>
#include <cstddef>

namespace glark::surfel::test {

using Matrix = std::array<float, 16>;

// Looks along -z from (x, y, z).
inline Matrix perspective(float x, float y, float z, float slope = 0.5F) {
  const float near = 0.01F, far = 100;
  const float a = -(far + near) / (far - near), b = -2 * far * near / (far - near);
  return {1 / slope, 0, 0, 0, 0, 1 / slope, 0, 0, 0, 0, a, -1, -x / slope, -y / slope, -z * a + b, z};
}

inline Matrix parallel(float half_width) {
  return {1 / half_width, 0, 0, 0, 0, 1 / half_width, 0, 0, 0, 0, -0.01F, 0, 0, 0, 0, 1};
}

// The point in clip space.
inline std::array<float, 4> clip(const Matrix& m, const float* p) {
  std::array<float, 4> at{};
  for (std::size_t r = 0; r < 4; ++r) at[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
  return at;
}

}  // namespace glark::surfel::test
