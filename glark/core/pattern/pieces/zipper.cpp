// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/pattern/pieces/zipper.h"

namespace glark::pattern {
namespace {

std::int64_t squared_length(LatticeVertex a, LatticeVertex b) {
  std::int64_t du = a.u - b.u;
  std::int64_t dv = a.v - b.v;
  return du * du + du * dv + dv * dv;
}

}  // namespace

void zip(std::span<const LatticeVertex> vertices, std::span<const std::uint16_t> right,
         std::span<const std::uint16_t> left, std::vector<std::uint16_t>& indices) {
  std::size_t i = 0;
  std::size_t j = 0;
  std::size_t last_i = right.size() - 1;
  std::size_t last_j = left.size() - 1;
  if (right.front() == left.front()) {
    indices.insert(indices.end(), {right[0], right[1], left[1]});
    i = j = 1;
  }
  bool closed = right.back() == left.back();
  if (closed) {
    --last_i;
    --last_j;
  }
  while (i < last_i || j < last_j) {
    bool advance_right = j == last_j || (i < last_i && squared_length(vertices[right[i + 1]], vertices[left[j]]) <=
                                                           squared_length(vertices[right[i]], vertices[left[j + 1]]));
    if (advance_right) {
      indices.insert(indices.end(), {right[i], right[i + 1], left[j]});
      ++i;
    } else {
      indices.insert(indices.end(), {right[i], left[j + 1], left[j]});
      ++j;
    }
  }
  if (closed) indices.insert(indices.end(), {right[last_i], right.back(), left[last_j]});
}

}  // namespace glark::pattern
