// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Delaunay triangulation of a few points of a plane, with exact predicates.
// Based on: Boubekeur 2007, alg. 3, which inserts the points one by one and searches all triangles for those that a
// point invalidates. We walk to the point and grow the cavity from there (Bowyer, Computing Dirichlet tessellations,
// 1981).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

class Delaunay {
 public:
  static constexpr std::int32_t max_coordinate = 1 << 20;  // coordinates are clamped to +- this
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  struct Point {
    std::int32_t x, y;
  };
  struct Place {
    double x, y;
  };
  // The corners are counter-clockwise. Side i is the edge opposite to corners[i].
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    std::array<std::uint32_t, 3> links;  // the neighbour across each side, and its side there; `none` on the outside
  };
  static std::uint32_t triangle_of(std::uint32_t link) { return link >> 2; }
  static std::uint32_t side_of(std::uint32_t link) { return link & 3; }

  // Only one of several duplicates gets triangles. It is one of the first `preferred` points, if there is such a
  // duplicate.
  void triangulate(std::span<const Point> points, std::size_t preferred = 0);

  // Three far points enclose the input. Corners with numbers beyond the input are far points.
  std::span<const Triangle> triangles() const { return {triangles_.data(), made_}; }
  // Returns whether all corners are points of the input.
  bool finite(const Triangle& triangle) const {
    return triangle.corners[0] < count_ && triangle.corners[1] < count_ && triangle.corners[2] < count_;
  }

  // Returns the corner of the neighbour across `side` that is opposite to the common edge.
  std::uint32_t across(std::uint32_t triangle, std::uint32_t side) const {
    const std::uint32_t link = triangles_[triangle].links[side];
    return triangles_[triangle_of(link)].corners[side_of(link)];
  }
  // Returns whether the two triangles at the side form a strictly convex quadrilateral.
  bool can_flip(std::uint32_t triangle, std::uint32_t side) const;
  // Flips the edge. Then the first corner of both triangles is the corner that was opposite to the edge in `triangle`.
  void flip(std::uint32_t triangle, std::uint32_t side);

 private:
  struct Corner {
    double x, y;  // relative to the inserted point
    std::uint32_t index;
  };
  // A side of the cavity around the inserted point. It begins where the previous side ends.
  struct Side {
    Corner end;
    double lift;   // the squared distance of the end from the point
    double cross;  // twice the area of the triangle between the side and the point
    std::uint32_t link;
  };

  static std::uint32_t link_to(std::uint32_t triangle, std::uint32_t side) { return triangle << 2 | side; }
  Corner corner(std::uint32_t index, Place from) const {
    return {places_[index].x - from.x, places_[index].y - from.y, index};
  }

  void place_points(std::span<const Point> points);
  void sort_points(Place low, Place high);
  void insert(std::uint32_t index, std::uint32_t following);
  std::uint32_t locate(Place point);
  void resolve_duplicate(std::uint32_t triangle, std::uint32_t index);
  bool grow_cavity(Side& side, Side& added, const Corner& start, double start_lift, Place point);
  void fill_cavity(std::uint32_t triangle, std::uint32_t index, std::uint32_t following);

  std::uint32_t count_ = 0, preferred_ = 0;
  std::vector<Place> places_;
  std::vector<std::uint32_t> cells_, starts_, order_;
  std::vector<Triangle> triangles_;  // the first `made_` are valid
  std::uint32_t made_ = 0;
  std::uint32_t last_ = 0;             // where the next walk begins
  std::vector<Side> sides_;            // a stack of cavity sides; the next side in counter-clockwise order is on top
  std::vector<std::uint32_t> vacant_;  // numbers for the triangles that fill the cavity
};

}  // namespace glark::surfel
