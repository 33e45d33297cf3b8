// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Delaunay triangulation of a few points of a plane, with exact predicates.
// Based on: Boubekeur 2007, alg. 3, which inserts point after point; with a walk to the point and flips of edges (Lawson 1977)
// in place of its loop over all triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

class Delaunay {
 public:
  static constexpr std::int32_t greatest = 1 << 20;  // of a coordinate's magnitude
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  struct Point {
    std::int32_t x, y;
  };
  // Counter-clockwise; neighbours[i] lies across the edge opposite to corners[i].
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    std::array<std::uint32_t, 3> neighbours;
  };

  // Of points at one place, the first has triangles.
  void triangulate(std::span<const Point> points);

  // Those of corners beyond the number of points reach to the three points far away that enclose all.
  std::span<const Triangle> triangles() const { return triangles_; }
  // Whether the corners are points of the input.
  bool finite(const Triangle& triangle) const;

  // The corner of the neighbour across edge `side` that the triangle has not.
  std::uint32_t across(std::uint32_t triangle, std::uint32_t side) const;
  // Whether the two triangles at the edge are a strictly convex quadrilateral.
  bool can_flip(std::uint32_t triangle, std::uint32_t side) const;
  // Turns the edge. The triangle has what was opposite to it first, then; and so the neighbour that it had.
  void flip(std::uint32_t triangle, std::uint32_t side);

 private:
  std::uint32_t locate(Point point) const;
  void insert(std::uint32_t index);
  void legalise(std::uint32_t triangle, bool forced);
  bool in_circle(const Triangle& triangle, Point point) const;
  void replace_neighbour(std::uint32_t of, std::uint32_t before, std::uint32_t now);

  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> pending_;
  std::uint32_t count_ = 0;
  mutable std::uint32_t last_ = 0;
};

}  // namespace glark::surfel
