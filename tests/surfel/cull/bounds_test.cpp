// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

// The test uses the drawn triangles, with flipped edges.
TEST(SurfelBounds, ConesContainAllNormalsAndTheApexIsBehindAllTriangles) {
  const Points points = torus(20000);
  const Strips strips(points.cloud());
  ASSERT_GT(strips.counts().turned, 500U);
  std::size_t leaf = 0, narrow_cones = 0;
  const auto all = patches(strips);
  for (const Node& node : strips.nodes()) {
    if (node.left != none || node.count == 0) continue;
    const auto& patch = all[leaf++];
    if (node.cone_sine >= 1) continue;
    ++narrow_cones;
    const double least_cosine = std::sqrt(1 - double{node.cone_sine} * node.cone_sine);
    for (const auto& [a, b, c] : patch) {
      const auto at = [&](std::uint32_t point, std::size_t k) { return double{points.positions[3UL * point + k]}; };
      std::array<double, 3> u{}, v{};
      for (std::size_t k = 0; k < 3; ++k) {
        u[k] = at(b, k) - at(a, k);
        v[k] = at(c, k) - at(a, k);
      }
      double size = 0, along = 0, above = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double normal = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
        size += normal * normal;
        along += normal * node.cone_axis[k];
        above += normal * (at(a, k) - node.cone_apex[k]);
      }
      EXPECT_GE(along / std::sqrt(size), least_cosine);
      EXPECT_GE(above / std::sqrt(size), 0);
    }
  }
  EXPECT_GT(narrow_cones, leaf / 2);
}

}  // namespace
}  // namespace glark::surfel::test
