// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Layers that face the same way and are nearer to each other than the planes of the samples reach.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include <glark/reconstruct.h>

#include "glark/clients/common/vector.h"
#include "tests/vstree/shapes.h"

namespace glark::reconstruct::test {
namespace {

constexpr double spacing = 0.02;  // of the samples

struct Nest {
  int layers = 2;
  double apart = 4;      // in spacings
  double noise = 0;      // in spacings
  bool is_open = false;  // half-spheres
  double radius(int layer) const { return 1 + layer * apart * spacing; }
  double area() const {
    double sum = 0;
    for (int i = 0; i < layers; ++i) sum += (is_open ? 2 : 4) * std::numbers::pi * radius(i) * radius(i);
    return sum;
  }
};

// Random samples of spheres around one another. All normals point outwards.
vstree::test::Shape samples_of(const Nest& nest, unsigned seed) {
  vstree::test::Shape shape;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int layer = 0; layer < nest.layers; ++layer) {
    const double radius = nest.radius(layer);
    const auto count =
        static_cast<int>((nest.is_open ? 2 : 4) * std::numbers::pi * radius * radius / (spacing * spacing));
    for (int i = 0; i < count; ++i) {
      double way[3] = {normal(random), normal(random), normal(random)};
      if (nest.is_open) way[2] = std::abs(way[2]);
      const double size = std::hypot(way[0], way[1], way[2]);
      const double out = radius + nest.noise * spacing * normal(random);
      for (const double x : way) {
        shape.positions.push_back(static_cast<float>(out * x / size));
        shape.normals.push_back(static_cast<float>(x / size));
      }
    }
  }
  return shape;
}

void expect_all_layers(const Nest& nest, unsigned seed) {
  const vstree::test::Shape samples = samples_of(nest, seed);
  const Reconstructed mesh = reconstruct(samples.points(), {.levels = 1});
  EXPECT_EQ(vstree::test::parts_of(mesh), static_cast<std::size_t>(nest.layers));
  const vstree::test::EdgeFaults faults = vstree::test::edge_faults(mesh.triangles);
  EXPECT_EQ(faults.non_manifold, 0U);
  if (!nest.is_open) {
    EXPECT_EQ(faults.boundary, 0U);
  }
  double squares = 0, area = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const double radius = std::hypot(mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]);
    const double layer = std::round((radius - 1) / (nest.apart * spacing));
    squares += std::pow(radius - nest.radius(static_cast<int>(layer)), 2);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const auto at = [&](std::size_t k) {
      return common::vector_at(std::span<const float>(mesh.positions), mesh.triangles[t + k]);
    };
    area += static_cast<double>(common::length(common::cross(at(1) - at(0), at(2) - at(0)))) / 2;
  }
  EXPECT_LT(std::sqrt(squares / (static_cast<double>(mesh.positions.size()) / 3)), std::max(0.1, nest.noise) * spacing);
  EXPECT_NEAR(area, nest.area(), (nest.is_open ? 0.05 : 0.02) * nest.area());
}

// Without groups of their own, the area is .3 to .9 of that of the layers, and nothing is told.
TEST(Layers, OfNestedSpheresAreAllThere) {
  for (const double apart : {2.5, 3.0, 4.2, 6.0, 9.0}) {
    for (const int layers : {2, 3}) {
      SCOPED_TRACE(std::to_string(layers) + " layers, " + std::to_string(apart) + " spacings apart");
      expect_all_layers({.layers = layers, .apart = apart}, static_cast<unsigned>(layers));
    }
  }
}

TEST(Layers, OfNestedBowlsWithNoiseAreAllThere) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    expect_all_layers({.layers = 3, .apart = 5, .noise = 0.2, .is_open = true}, seed);
  }
}

// Two scans of one surface, less than a spacing apart, are no layers.
TEST(Layers, OfTwoScansAreOneSurface) {
  const vstree::test::Shape samples = samples_of({.layers = 2, .apart = 0.5}, 4);
  EXPECT_EQ(vstree::test::parts_of(reconstruct(samples.points(), {.levels = 1})), 1U);
}

}  // namespace
}  // namespace glark::reconstruct::test
