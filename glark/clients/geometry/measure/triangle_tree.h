// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A tree of boxes over triangles, which finds the triangle that is nearest to a point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glark/clients/geometry/geometry.h"
#include "glark/clients/geometry/measure/nearest_on_triangle.h"

namespace glark::geometry {

class TriangleTree {
 public:
  struct Nearest {
    std::uint32_t triangle = 0;
    double square = 0;  // the squared distance
  };

  // The geometry has at least one triangle and outlives the tree. `shift` is added to its positions.
  TriangleTree(const Geometry& geometry, const std::array<double, 3>& shift);

  // Returns the nearest triangle. `guess` is any triangle; a near one saves time. If a triangle is found whose squared
  // distance is at most `enough`, the search ends with it.
  Nearest nearest_to(const Vector& from, std::uint32_t guess, double enough = 0) const;
  std::array<Vector, 3> corners_of(std::size_t triangle) const;

 private:
  struct Box {
    Vector low, high;
  };
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;  // a range of order_
    std::uint32_t children = 0;        // the first of two that follow each other; 0: a leaf
  };

  void split(std::size_t node, const std::vector<Box>& boxes);
  double square_to(const Vector& from, std::uint32_t triangle) const;

  const Geometry& geometry_;
  std::array<double, 3> shift_;
  std::vector<std::uint32_t> order_;  // triangles; those of a node follow one another
  std::vector<Node> nodes_;
};

}  // namespace glark::geometry
