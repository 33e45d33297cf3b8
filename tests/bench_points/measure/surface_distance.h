// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The distance of points from a triangle mesh, and the edges that are not manifold.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace glark::bench {

class SurfaceDistance {
 public:
  // The arrays must outlive this object, and have at least one triangle.
  SurfaceDistance(std::span<const float> positions, std::span<const std::uint32_t> triangles);
  double squared(const std::array<double, 3>& point) const;
  // Returns the root mean square distance of the points [3 * count].
  double rms(std::span<const float> points) const;

 private:
  using Point = std::array<double, 3>;
  std::size_t index_of(const std::array<int, 3>& cell) const;
  void look_into(std::array<int, 3> cell, const Point& point, double& best) const;

  std::span<const float> positions_;
  std::span<const std::uint32_t> triangles_;
  Point low_{};
  double cell_ = 1;
  std::array<int, 3> cells_{};
  std::vector<std::uint32_t> begins_, entries_;
};

// Returns random points on the triangles, evenly by area: [3 * count]. They are the same every time.
std::vector<float> samples_of(std::span<const float> positions, std::span<const std::uint32_t> triangles,
                              std::size_t count);

struct Edges {
  std::size_t boundary = 0;      // edges of one triangle
  std::size_t non_manifold = 0;  // edges of more than two triangles
};
Edges edges_of(std::span<const std::uint32_t> triangles);

double diagonal_of(std::span<const float> positions);

}  // namespace glark::bench
