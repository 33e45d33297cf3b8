// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Delaunay triangulation of a few points of a plane, with exact predicates.
// Based on: Boubekeur 2007, alg. 3, which inserts point after point; with a walk to the point, and from there to the triangles
// that make way for it (Bowyer 1981), in place of its loop over all triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glark::surfel {

class Delaunay {
 public:
  static constexpr std::int32_t greatest = 1 << 20;  // of a coordinate's magnitude; those beyond are taken for it
  static constexpr std::uint32_t none = 0xFFFFFFFFU;

  struct Point {
    std::int32_t x, y;
  };
  struct Place {
    double x, y;
  };
  // Counter-clockwise; links[i] leads across the edge opposite to corners[i].
  struct Triangle {
    std::array<std::uint32_t, 3> corners;
    std::array<std::uint32_t, 3> links;  // a triangle, and which of its sides that is; `none` on the outside
  };
  static std::uint32_t triangle_of(std::uint32_t link) { return link >> 2; }
  static std::uint32_t side_of(std::uint32_t link) { return link & 3; }

  // Of points at one place, one has triangles: one of the first `preferred`, if there is one of these.
  void triangulate(std::span<const Point> points, std::size_t preferred = 0);

  // Those of corners beyond the number of points reach to the three points far away that enclose all.
  std::span<const Triangle> triangles() const { return {triangles_.data(), made_}; }
  // Whether the corners are points of the input.
  bool finite(const Triangle& triangle) const {
    return triangle.corners[0] < count_ && triangle.corners[1] < count_ && triangle.corners[2] < count_;
  }

  // The corner of the neighbour across edge `side` that the triangle has not.
  std::uint32_t across(std::uint32_t triangle, std::uint32_t side) const {
    const std::uint32_t link = triangles_[triangle].links[side];
    return triangles_[triangle_of(link)].corners[side_of(link)];
  }
  // Whether the two triangles at the edge are a strictly convex quadrilateral.
  bool can_flip(std::uint32_t triangle, std::uint32_t side) const;
  // Turns the edge. The triangle has what was opposite to it first, then; and so the neighbour that it had.
  void flip(std::uint32_t triangle, std::uint32_t side);

 private:
  struct Corner {
    double x, y;  // from the point that is inserted
    std::uint32_t index;
  };
  // Of the cavity around that point; it begins where the side before it ends.
  struct Side {
    Corner end;
    double lift;   // the end's squared distance
    double cross;  // of its two ends: twice the area between it and the point
    std::uint32_t link;
  };

  static std::uint32_t link_to(std::uint32_t triangle, std::uint32_t side) { return triangle << 2 | side; }
  Corner corner(std::uint32_t index, Place from) const {
    return {places_[index].x - from.x, places_[index].y - from.y, index};
  }

  void place(std::span<const Point> points);
  void sort(Place low, Place high);
  void insert(std::uint32_t index, std::uint32_t following);
  std::uint32_t locate(Place point);
  void prefer(std::uint32_t triangle, std::uint32_t index);
  void connect(std::uint32_t triangle, std::uint32_t index, std::uint32_t following);

  std::uint32_t count_ = 0, preferred_ = 0;
  std::vector<Place> places_;
  std::vector<std::uint32_t> cells_, starts_, order_;
  std::vector<Triangle> triangles_;  // the first `made_` of them
  std::uint32_t made_ = 0;
  std::uint32_t last_ = 0;
  std::vector<Side> sides_;            // a stack: the next in counter-clockwise order is on top
  std::vector<std::uint32_t> vacant_;  // triangles to be made
};

}  // namespace glark::surfel
