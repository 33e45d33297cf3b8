// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Inflates leaves: projects the points of a leaf, and nearby points of its neighbours, onto the leaf's plane.
// Based on: Boubekeur 2007, ch. 5.2.1.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/tree/stripping_tree.h"
#include "glark/clients/surfel/triangulate/delaunay.h"
#include "glark/clients/surfel/triangulate/proximity_grid.h"

namespace glark::surfel {

// Finds the leaves whose points `leaf` may take in, and the leaves that may take in points of `leaf`.
void find_neighbours(const StrippingTree& tree, std::uint32_t leaf, std::vector<std::uint32_t>& found);

// Inflates leaves one by one, and reuses its memory.
class LeafInflation {
 public:
  struct Member {
    Vector position;
    std::uint32_t index;
    Vector normal;
    std::array<float, 3> projected;  // two coordinates on the leaf's plane, and the height above it
  };

  explicit LeafInflation(const StrippingTree& tree) : tree_(tree) {}

  void inflate(std::uint32_t leaf);

  // The leaf's own points come first.
  std::span<const Member> members() const { return members_; }
  std::size_t own_count() const { return own_count_; }
  // Integer positions of the members on the plane.
  std::span<const Delaunay::Point> plane_points() const { return plane_points_; }

 private:
  // The plane of the leaf that is being inflated.
  struct Frame {
    const Leaf* leaf = nullptr;
    Box box;
    Vector u, v;              // axes of the plane
    float low = 0, high = 0;  // least and greatest height of the leaf's own points
  };

  std::array<float, 3> unroll(const Surfel& surfel) const;
  void add(const Surfel& surfel, const std::array<float, 3>& projected);
  void add_own_points();
  void add_nearby_points(const Leaf& neighbour);
  void keep_nearest();
  void quantize();

  const StrippingTree& tree_;
  std::vector<Member> members_;
  std::size_t own_count_ = 0;
  std::vector<Delaunay::Point> plane_points_;
  Frame frame_;
  std::vector<std::uint32_t> neighbours_;
  std::vector<ProximityGrid::Place> own_places_;
  ProximityGrid proximity_;
};

}  // namespace glark::surfel
