// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points and normals of a surface as Float4, whose fourth number is 0.
#pragma once

#include <glark/qas.h>

#include <cmath>
#include <cstring>

#include "glark/clients/common/float4.h"

namespace glark::qas {

using namespace common;  // Float4 and its functions

inline void store(Vector& to, Float4 value) { std::memcpy(&to, &value, sizeof(to)); }

inline Float4 load(const Vector& from) { return Float4{from.x, from.y, from.z, 0}; }

// Smaller squares underflow. Tangents with a smaller squared sine are parallel in single precision.
inline constexpr float least_square = 1e-36F;
inline constexpr float parallel = 1e-12F;

// Finds the unit normal of two tangents. Returns false if they are parallel.
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
