// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A statue: a solid with a body, a head, arms and legs. Its pose and its proportions follow from a seed.
#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace glark::shapes {

using Point = std::array<double, 3>;

class Statue {
 public:
  explicit Statue(unsigned seed);

  // The approximate signed distance from the surface: negative inside.
  double distance(const Point& point) const;
  // The gradient of distance(), with length 1.
  Point normal(const Point& point) const;
  // Moves a point near the surface onto it.
  Point on_surface(Point point) const;
  // The corners of a box that contains the statue. It stands along z.
  const Point& low() const { return low_; }
  const Point& high() const { return high_; }
  double diagonal() const;

 private:
  struct Limb {
    Point from, to;
    double radius;
  };
  void add(const Point& from, const Point& to, double radius);

  std::vector<Limb> limbs_;
  Point low_{1e9, 1e9, 1e9}, high_{-1e9, -1e9, -1e9};
};

}  // namespace glark::shapes
