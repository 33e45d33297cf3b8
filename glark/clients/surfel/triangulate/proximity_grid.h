// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Answers whether a place of the plane is near a set of points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

// A set of points, dilated by a disc and rasterized to a bitmap. There is one bitmap for each distance. Answers are
// exact to one cell. A cell is a sixtieth of the points' extent plus twice the greatest distance.
class ProximityGrid {
 public:
  using Place = std::array<float, 2>;

  // The caller keeps the points until the last query. Distances of queries are at most `greatest_distance`.
  void begin(std::span<const Place> points, float greatest_distance);
  // Returns whether a point lies within the distance of the place. The distance may be rounded up by a quarter.
  bool is_near(Place place, float distance);

 private:
  static constexpr int cells = 64;  // cells along each axis
  struct Bitmap {
    float distance;
    std::array<std::uint64_t, cells> rows;
  };

  const Bitmap& bitmap_for(float distance);
  void rasterize(Bitmap& bitmap) const;

  std::span<const Place> points_;
  Place low_{}, scale_{};  // the origin of the grid, and the cells per unit
  float greatest_distance_ = 0;
  std::vector<Bitmap> bitmaps_;
  std::size_t used_ = 0;    // the number of bitmaps for these points
  std::size_t latest_ = 0;  // the bitmap of the last query
};

}  // namespace glark::surfel
