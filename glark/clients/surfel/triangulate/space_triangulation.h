// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The triangulation of an inflated leaf. First it is Delaunay in the leaf's plane. Then edges are flipped until it is
// Delaunay in space.
// Based on: Boubekeur 2007, ch. 5.2.1, for the triangulation in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/triangulate/delaunay.h"
#include "glark/clients/surfel/triangulate/leaf_inflation.h"

namespace glark::surfel {

// Triangulates leaves one by one, and reuses its memory.
class SpaceTriangulation {
 public:
  // The shape of a triangle in space.
  struct Facet {
    std::array<float, 3> cotangents;       // the cotangents of the angles at the corners
    std::array<float, 3> squared_lengths;  // the squared lengths of the edges opposite to the corners
    Vector normal;
  };

  explicit SpaceTriangulation(const StrippingTree& tree) : inflation_(tree) {}

  void triangulate(std::uint32_t leaf);

  const Delaunay& delaunay() const { return delaunay_; }
  std::span<const Delaunay::Triangle> triangles() const { return delaunay_.triangles(); }
  const Facet& facet(std::uint32_t triangle) const { return facets_[triangle]; }
  const LeafInflation::Member& member(std::uint32_t corner) const { return inflation_.members()[corner]; }
  std::size_t member_count() const { return inflation_.members().size(); }
  // The leaf's own points are the first members.
  std::size_t own_count() const { return inflation_.own_count(); }

  // Returns whether a corner is one of the leaf's own points.
  bool is_inner(const Delaunay::Triangle& triangle) const {
    return std::min({triangle.corners[0], triangle.corners[1], triangle.corners[2]}) < own_count();
  }
  // Returns whether all corners are the leaf's own points.
  bool is_interior(const Delaunay::Triangle& triangle) const {
    return std::max({triangle.corners[0], triangle.corners[1], triangle.corners[2]}) < own_count();
  }
  // Returns whether the normals of the corners point to the other side. At sharp creases, triangles can be upside down
  // in the leaf's plane.
  bool is_back_facing(std::uint32_t triangle) const {
    const auto [a, b, c] = triangles()[triangle].corners;
    return dot(facets_[triangle].normal, member(a).normal + member(b).normal + member(c).normal) < 0;
  }

  // Flips the edge at a side; see Delaunay::flip().
  void flip(std::uint32_t triangle, std::uint32_t side);

 private:
  void measure(std::uint32_t triangle);
  bool may_violate_delaunay(std::uint32_t triangle, std::uint32_t side) const;
  bool prefers_other_diagonal(std::uint32_t triangle, std::uint32_t side) const;
  void flip_if_better(std::uint32_t triangle, std::uint32_t side);
  void flip_for_delaunay();

  LeafInflation inflation_;
  Delaunay delaunay_;
  std::vector<Facet> facets_;           // one for each triangle
  std::vector<std::uint32_t> pending_;  // triangles whose edges will be checked again
};

}  // namespace glark::surfel
