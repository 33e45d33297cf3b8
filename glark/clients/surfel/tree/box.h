// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Axis-aligned boxes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "glark/clients/surfel/tree/vector.h"

namespace glark::surfel {

// The box is empty until a point is added.
struct Box {
  static constexpr float far = std::numeric_limits<float>::max();
  Vector low{far, far, far};
  Vector high{-far, -far, -far};

  bool empty() const { return low.x > high.x; }
  Vector extent() const { return empty() ? Vector{} : high - low; }
  Vector centre() const { return empty() ? Vector{} : low + (high - low) * 0.5F; }
  void add(Vector point) {
    low = least(low, point);
    high = greatest(high, point);
  }
  void add(const Box& other) {
    low = least(low, other.low);
    high = greatest(high, other.high);
  }
  std::size_t widest_axis() const {
    const Vector size = extent();
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }
};

inline float squared_distance(const Box& box, Vector point) {
  const Vector outside = greatest(greatest(box.low - point, point - box.high), Vector{});
  return dot(outside, outside);
}
inline float squared_distance(const Box& a, const Box& b) {
  const Vector gap = greatest(greatest(a.low - b.high, b.low - a.high), Vector{});
  return dot(gap, gap);
}

}  // namespace glark::surfel
