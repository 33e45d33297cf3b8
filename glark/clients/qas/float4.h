// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points and vectors as four floats, of which the compiler makes vector instructions; the fourth is 0.
#pragma once

#include <glark/qas.h>

#include <cmath>
#include <cstring>

namespace glark::qas {

using Float4 = float __attribute__((vector_size(16)));

inline void store(Vector& to, Float4 value) { std::memcpy(&to, &value, sizeof(to)); }

inline Float4 load(const Vector& from) { return Float4{from.x, from.y, from.z, 0}; }

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

// Squares below are lost to the range of floats; a square of a sine below makes two tangents parallel in single precision.
inline constexpr float least_square = 1e-36F;
inline constexpr float parallel = 1e-12F;

// The unit normal of two tangents; false where they are parallel.
inline bool unit_normal(Float4 first, Float4 second, Float4& normal) {
  const Float4 product = cross(first, second);
  const float square = dot(product, product);
  if (!(square > parallel * dot(first, first) * dot(second, second)) || square < least_square) return false;
  normal = product / std::sqrt(square);
  return true;
}

inline Float4 unit_or_z(Float4 vector) {
  const float square = dot(vector, vector);
  if (!(square >= least_square)) return Float4{0, 0, 1, 0};
  return vector / std::sqrt(square);
}

}  // namespace glark::qas
