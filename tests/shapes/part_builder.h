// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Puts meshes together from grids. Points at one position are one vertex.
#pragma once

#include <array>
#include <cmath>
#include <map>

#include "tests/shapes/parts.h"
#include "tests/shapes/solids.h"

namespace glark::shapes {

inline constexpr double pi = 3.14159265358979323846;

class PartBuilder {
 public:
  std::uint32_t vertex(const Point& point) {
    constexpr double grid = 1e6;
    const std::array<long long, 3> key{std::llround(point[0] * grid), std::llround(point[1] * grid),
                                       std::llround(point[2] * grid)};
    const auto [at, is_new] = found_.try_emplace(key, static_cast<std::uint32_t>(part_.positions.size() / 3));
    if (is_new) {
      for (const double number : point) part_.positions.push_back(static_cast<float>(number));
    }
    return at->second;
  }

  void triangle(const Point& a, const Point& b, const Point& c) {
    const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
    if (i != j && j != k && k != i) part_.triangles.insert(part_.triangles.end(), {i, j, k});
  }

  // Adds columns * rows quadrilaterals over the unit square. They face along du x dv. `at` gives the points.
  template <typename At>
  void grid(int columns, int rows, const At& at, bool is_turned = false) {
    for (int i = 0; i < columns; ++i) {
      for (int k = 0; k < rows; ++k) {
        const auto corner = [&](int a, int b) {
          return at(static_cast<double>(i + a) / columns, static_cast<double>(k + b) / rows);
        };
        const Point a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
        if (is_turned) {
          triangle(a, c, b);
          triangle(a, d, c);
        } else {
          triangle(a, b, c);
          triangle(a, c, d);
        }
      }
    }
  }

  // Points at one position become one vertex only if they are added before the next call.
  void begin_part() { found_.clear(); }
  Part take() { return std::move(part_); }

 private:
  Part part_;
  std::map<std::array<long long, 3>, std::uint32_t> found_;
};

inline Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

}  // namespace glark::shapes
