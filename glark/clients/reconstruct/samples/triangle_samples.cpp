// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/samples/triangle_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glark/clients/common/vector.h"

namespace glark::reconstruct {
namespace {

using Vector = common::Vector3d;

constexpr double long_sides = 3;  // the longest side of a long triangle, in mean distances of corners

struct Corners {
  Vector a, b, c;

  Vector across() const { return cross(b - a, c - a); }
  double area() const { return std::sqrt(dot(across(), across())) / 2; }
  double longest() const {
    return std::sqrt(std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
  }
};

Vector vertex(std::span<const float> positions, std::uint32_t i) {
  const auto at = common::vector_at(positions, i);
  return {at.x, at.y, at.z};
}

Corners corners_of(std::span<const float> positions, std::span<const std::uint32_t> triangles, std::size_t t) {
  return {vertex(positions, triangles[t]), vertex(positions, triangles[t + 1]), vertex(positions, triangles[t + 2])};
}

double area_of(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  double area = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) area += corners_of(positions, triangles, t).area();
  return area;
}

// Adds the samples of one triangle.
class Sampler {
 public:
  Sampler(std::span<const std::uint8_t> colours, TriangleSamples& samples) : colours_(colours), samples_(samples) {}

  void add(const Corners& corners, const std::uint32_t* vertices, double u, double v) {
    const double root = std::sqrt(u);
    const double weights[3] = {1 - root, root * (1 - v), root * v};
    const Vector point = corners.a * weights[0] + corners.b * weights[1] + corners.c * weights[2];
    const Vector normal = common::unit(corners.across());
    for (std::size_t k = 0; k < 3; ++k) {
      samples_.positions.push_back(static_cast<float>(point[k]));
      samples_.normals.push_back(static_cast<float>(normal[k]));
    }
    for (std::size_t k = 0; k < 4 && !colours_.empty(); ++k) {
      double colour = 0.5;
      for (std::size_t i = 0; i < 3; ++i) colour += weights[i] * colours_[4 * std::size_t{vertices[i]} + k];
      samples_.colours.push_back(static_cast<std::uint8_t>(colour));
    }
  }

 private:
  std::span<const std::uint8_t> colours_;
  TriangleSamples& samples_;
};

}  // namespace

double share_of_long_triangles(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  std::vector<bool> is_used(positions.size() / 3);
  for (const std::uint32_t i : triangles) is_used[i] = true;
  const auto corners = static_cast<double>(std::count(is_used.begin(), is_used.end(), true));
  const double area = area_of(positions, triangles);
  if (!(area > 0)) return 0;
  const double limit = long_sides * std::sqrt(area / corners);
  double long_area = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const Corners one = corners_of(positions, triangles, t);
    if (one.longest() > limit) long_area += one.area();
  }
  return long_area / area;
}

// A sample lies in each equal share of the area, taken triangle by triangle. Within its triangle, it lies at the next
// place of an additive recurrence, which fills the triangle evenly.
// Based on: M. Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018 (R2).
TriangleSamples sample_triangles(std::span<const float> positions, std::span<const std::uint8_t> colours,
                                 std::span<const std::uint32_t> triangles, std::size_t count) {
  constexpr double plastic = 1.32471795724474602596;
  TriangleSamples samples;
  Sampler sampler(colours, samples);
  const double share = area_of(positions, triangles) / static_cast<double>(count);
  double before = 0, next = share / 2;
  std::size_t number = 0;
  for (std::size_t t = 0; share > 0 && t < triangles.size(); t += 3) {
    const Corners corners = corners_of(positions, triangles, t);
    for (before += corners.area(); next < before; next += share) {
      ++number;
      const double u = static_cast<double>(number) / plastic, v = static_cast<double>(number) / (plastic * plastic);
      sampler.add(corners, &triangles[t], u - std::floor(u), v - std::floor(v));
    }
  }
  return samples;
}

}  // namespace glark::reconstruct
