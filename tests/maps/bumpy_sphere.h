// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A sphere with bumps, whose surface, normals and colours are known everywhere, and coarse spheres without bumps.
#pragma once

#include <glark/maps.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "glark/clients/common/vector.h"

namespace glark::maps::test {

using Precise = common::Vector3d;

struct Sphere {
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> colours;
  std::vector<std::uint32_t> triangles;

  CoarseMesh coarse() const { return {.positions = positions, .normals = normals, .triangles = triangles}; }
  FineMesh fine() const {
    return {.positions = positions, .normals = normals, .colours = colours, .triangles = triangles};
  }
};

// The height of the bumps in a direction.
inline double bump(Precise d) { return 0.03 * std::sin(5 * d.x) * std::cos(4 * d.y) + 0.02 * std::sin(7 * d.z); }
inline Precise bumpy_point(Precise d) { return d * (1 + bump(d)); }
inline Precise bumpy_normal(Precise d) {
  const Precise axis = std::abs(d.x) < 0.6 ? Precise{1, 0, 0} : Precise{0, 1, 0};
  const Precise u = common::unit(common::cross(d, axis));
  const Precise v = common::cross(d, u);
  constexpr double step = 1e-4;
  const auto at = [](Precise direction) { return bumpy_point(common::unit(direction)); };
  return common::unit(common::cross(at(d + u * step) - at(d - u * step), at(d + v * step) - at(d - v * step)));
}
inline std::array<double, 3> bumpy_colour(Precise d) {
  return {0.5 + 0.4 * d.x, 0.5 + 0.4 * std::sin(3 * d.y), 0.5 - 0.4 * d.z};
}

// An icosahedron whose triangles are divided into four, `levels` times.
inline Sphere sphere_of(unsigned levels, bool has_bumps) {
  const double t = (1 + std::sqrt(5.0)) / 2;
  std::vector<Precise> points{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                              {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  for (Precise& p : points) p = common::unit(p);
  std::vector<std::uint32_t> triangles{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                       4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                       6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (unsigned level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(common::unit(points[a] + points[b]));
      return at->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    triangles = std::move(finer);
  }
  Sphere sphere;
  sphere.triangles = std::move(triangles);
  for (const Precise& d : points) {
    const Precise p = has_bumps ? bumpy_point(d) : d;
    const Precise n = has_bumps ? bumpy_normal(d) : d;
    for (std::size_t k = 0; k < 3; ++k) {
      sphere.positions.push_back(static_cast<float>(p[k]));
      sphere.normals.push_back(static_cast<float>(n[k]));
      sphere.colours.push_back(static_cast<std::uint8_t>(std::lround(255 * bumpy_colour(d).at(k))));
    }
  }
  return sphere;
}

}  // namespace glark::maps::test
