// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edges that a run crosses, turned to the other diagonal of their two triangles where that saves indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/runs.h"
#include "glark/clients/surfel/vector.h"

namespace glark::surfel {

constexpr float flat = 0.9F;  // the least cosine between triangles of which an edge turns
// Whether triangles p, a, b and d, b, a may become p, a, d and p, d, b: all are flat, and the new ones nearly as good.
bool may_turn_edge(Vector p, Vector a, Vector d, Vector b);

// A strip goes around the points on its two sides in turn; where it goes around one on the same side twice, it has an index more. Two such
// places, on different sides, have none if the edges between them turn; so does one by its own if those up to the run's end turn.
// What is around the two triangles of such an edge stays as it is, so that patches match as before.
class Turning {
 public:
  explicit Turning(std::span<const Vector> positions) : positions_(positions) {}

  // How many edges turned.
  std::size_t run(std::span<StripTriangle> triangles);

 private:
  bool can_turn(const StripTriangle& one, const StripTriangle& other) const;
  bool can_turn_all(std::span<const StripTriangle> triangles, std::size_t first, std::size_t last) const;
  bool turn(std::span<StripTriangle> triangles, std::size_t at) const;
  void turn_all(std::span<StripTriangle> triangles, std::size_t first, std::size_t last);

  std::span<const Vector> positions_;
  std::vector<std::uint8_t> sides_;  // of the run's triangles, but for the first and last
  std::vector<std::size_t> doubled_;
  std::size_t turned_ = 0;
};

// The corner that is none of another triangle's.
std::uint32_t corner_off(const StripTriangle& triangle, const StripTriangle& other);
bool has(const StripTriangle& triangle, std::uint32_t point);
// The point that three triangles of a run have in common.
std::uint32_t common_point(const StripTriangle& a, const StripTriangle& b, const StripTriangle& c);

}  // namespace glark::surfel
