// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// How far points lie from a triangle mesh, and what is wrong with its edges.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace glark::bench {

class SurfaceDistance {
 public:
  // The arrays have to outlive it; at least one triangle.
  SurfaceDistance(std::span<const float> positions, std::span<const std::uint32_t> triangles);
  double squared(const std::array<double, 3>& point) const;
  // The root of the mean square over the points [3 * count].
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

// Points of the triangles, by area, [3 * count]: even over the surface, the same ones every time.
std::vector<float> samples_of(std::span<const float> positions, std::span<const std::uint32_t> triangles,
                              std::size_t count);

struct Edges {
  std::size_t boundary = 0;      // of one triangle
  std::size_t non_manifold = 0;  // of more than two
};
Edges edges_of(std::span<const std::uint32_t> triangles);

double diagonal_of(std::span<const float> positions);

}  // namespace glark::bench
