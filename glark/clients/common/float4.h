// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points and vectors of four floats, for loops of vector instructions. The fourth float is free for the user.
#pragma once

#include <array>
#include <bit>
#include <cmath>

namespace glark::common {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int __attribute__((vector_size(16)));

template <int lane>
inline Float4 splat(Float4 a) {
  return __builtin_shufflevector(a, a, lane, lane, lane, lane);
}

inline Float4 without_fourth(Float4 a) {
  constexpr Int4 kept{-1, -1, -1, 0};
  return std::bit_cast<Float4>(std::bit_cast<Int4>(a) & kept);
}

// The dot product of the first three floats.
inline float dot(Float4 a, Float4 b) {
  const Float4 product = a * b;
  return product[0] + product[1] + product[2];
}

inline Float4 cross(Float4 a, Float4 b) {
  const Float4 a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  const Float4 b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const Float4 zxy = a * b_yzx - a_yzx * b;
  return __builtin_shufflevector(zxy, zxy, 1, 2, 0, 3);
}

// Returns the vector with length 1, or zero for the zero vector.
inline Float4 unit(Float4 a) {
  const float square = dot(a, a);
  return square > 0 ? a / std::sqrt(square) : Float4{};
}

inline Float4 least(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 greatest(Float4 a, Float4 b) { return a > b ? a : b; }

inline std::array<float, 3> triple(Float4 a) { return {a[0], a[1], a[2]}; }

}  // namespace glark::common
