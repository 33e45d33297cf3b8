// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A leaf's points and those around it, over the leaf's plane.
// Based on: Boubekeur 2007, ch. 5.2.1.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "glark/clients/surfel/delaunay.h"
#include "glark/clients/surfel/nearness.h"
#include "glark/clients/surfel/stripping_tree.h"

namespace glark::surfel {

// Leaves of which points may be taken in, or that may take in points of this one.
void find_neighbours(const StrippingTree& tree, std::uint32_t leaf, std::vector<std::uint32_t>& found);

// Inflates leaves, one after the other, in memory that it keeps.
class Inflation {
 public:
  struct Member {
    Vector position;
    std::uint32_t index;
    Vector normal;
    std::array<float, 3> at;  // over the leaf's plane, and the height
  };

  explicit Inflation(const StrippingTree& tree) : tree_(tree) {}

  void make(std::uint32_t leaf);

  std::vector<Member> members;          // the leaf's own first
  std::size_t own = 0;                  // how many these are
  std::vector<Delaunay::Point> places;  // of the members, on the plane

 private:
  std::array<float, 3> unrolled(const Surfel& surfel) const;
  void take(const Surfel& surfel, const std::array<float, 3>& at);
  void take_own();
  void take_near(const Leaf& neighbour);
  void keep_nearest();
  void scale();

  const StrippingTree& tree_;
  const Leaf* leaf_ = nullptr;
  Box box_;
  Vector u_, v_;              // with the normal, the leaf's frame
  float low_ = 0, high_ = 0;  // heights of its points
  std::vector<std::uint32_t> neighbours_;
  std::vector<Nearness::Place> own_places_;
  Nearness nearness_;
};

}  // namespace glark::surfel
