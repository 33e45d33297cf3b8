// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "glark/clients/geometry/measure/triangle_tree.h"

namespace glark::geometry {
namespace {

// Triangles of all sizes and shapes in the unit cube, some without area.
Geometry random_triangles(unsigned seed, std::uint32_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  Geometry mesh;
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::array<float, 3> middle{uniform(random), uniform(random), uniform(random)};
    const float size = t % 7 == 0 ? 0 : uniform(random) * uniform(random) * uniform(random);
    for (std::uint32_t k = 0; k < 3; ++k) {
      for (const float number : middle) mesh.positions.push_back(number + size * (uniform(random) - 0.5F));
      mesh.triangles.push_back(3 * t + k);
    }
  }
  return mesh;
}

TEST(TriangleTree, FindsTheNearestTriangle) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    for (const std::uint32_t count : {1U, 2U, 5U, 300U}) {
      const Geometry mesh = random_triangles(seed, count);
      const TriangleTree tree(mesh, {1, 0, 0});
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> uniform(-0.5, 2.5);
      for (int i = 0; i < 200; ++i) {
        const Vector from{uniform(random), uniform(random), uniform(random)};
        double least = std::numeric_limits<double>::infinity();
        for (std::uint32_t t = 0; t < count; ++t)
          least = std::min(least, squared_distance(from, nearest_on_triangle(from, tree.corners_of(t))));
        EXPECT_DOUBLE_EQ(tree.nearest_to(from, static_cast<std::uint32_t>(i) % count).square, least);
        const double enough = tree.nearest_to(from, 0, 2 * least).square;
        EXPECT_TRUE(least <= enough && (enough <= 2 * least || enough == least));
      }
    }
  }
}

TEST(Distance, FromAReferenceIsTheHausdorffDistance) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    Geometry reference = random_triangles(seed, 200), result = random_triangles(seed + 10, 30);
    reference.origin = {5, 0, 0};
    result.origin = {5.25, 0, 0};
    const double expected = distance_between(result, reference, {}).hausdorff();
    const HausdorffDistance distance = hausdorff_from(reference);
    EXPECT_DOUBLE_EQ(distance(result, {}), expected);
    EXPECT_DOUBLE_EQ(distance(result, {.least = 2 * expected}), 2 * expected);
    EXPECT_GT(distance(result, {.most = expected / 2}), expected / 2);
    EXPECT_DOUBLE_EQ(distance(result, {.most = expected * (1 + 1e-9)}), expected);
    EXPECT_LE(distance(result, {.one_of = 100}), expected * (1 + 1e-3));
  }
}

}  // namespace
}  // namespace glark::geometry
