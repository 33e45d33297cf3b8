// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Finds the triangle that is nearest to a point, by Eigen's hierarchy of bounding boxes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

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
  ~TriangleTree();
  TriangleTree(const TriangleTree&) = delete;
  TriangleTree& operator=(const TriangleTree&) = delete;

  // Returns the nearest triangle. `guess` is any triangle; a near one saves time. If a triangle is found whose squared
  // distance is at most `enough`, the search ends with it.
  Nearest nearest_to(const Vector& from, std::uint32_t guess, double enough = 0) const;
  std::array<Vector, 3> corners_of(std::size_t triangle) const;

 private:
  struct Boxes;

  const Geometry& geometry_;
  std::array<double, 3> shift_;
  std::unique_ptr<Boxes> boxes_;
};

}  // namespace glark::geometry
