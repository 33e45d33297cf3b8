// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Flips edges within a run of triangles where that saves indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/level/candidate.h"
#include "glark/clients/surfel/tree/vector.h"

namespace glark::surfel {

// A strip passes around points on its left and right side in turn. If it passes around two successive points on the
// same side, it needs a swap: one more index. Flipping edges removes swaps:
// - Two swaps on different sides cancel if the edges between them are flipped.
// - A single swap vanishes if all edges up to an end of the run are flipped.
// The outer edges of the run stay, so patches match as before.
class EdgeFlipper {
 public:
  explicit EdgeFlipper(std::span<const Vector> positions) : positions_(positions) {}

  // Each triangle of the run must share an edge with the next one. Returns the number of flipped edges.
  std::size_t run(std::span<Triangle> triangles);

 private:
  void find_swaps(std::span<const Triangle> triangles);
  bool may_flip(const Triangle& one, const Triangle& other) const;
  bool may_flip_range(std::span<const Triangle> triangles, std::size_t first, std::size_t last) const;
  bool flip(std::span<Triangle> triangles, std::size_t at) const;
  bool flip_range(std::span<Triangle> triangles, std::size_t first, std::size_t last);

  std::span<const Vector> positions_;
  std::vector<std::uint8_t> sides_;  // for each inner triangle, the side of its pivot point
  std::vector<std::size_t> swaps_;   // triangles whose pivot is on the same side as the pivot of the next triangle
  std::size_t flipped_ = 0;
};

bool has_corner(const Triangle& triangle, std::uint32_t point);
// Returns the index of the corner that the other triangle does not have.
std::uint32_t opposite_corner(const Triangle& triangle, const Triangle& other);
// Returns the point that three successive triangles of a run have in common.
std::uint32_t pivot_point(const Triangle& a, const Triangle& b, const Triangle& c);

}  // namespace glark::surfel
