// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

class Simplify : public testing::TestWithParam<Clustering> {};
INSTANTIATE_TEST_SUITE_P(All, Simplify,
                         testing::Values(Clustering::volume_surface, Clustering::octree, Clustering::grid));

TEST_P(Simplify, ComesCloseToTheTargetFromBelow) {
  const Shape shape = torus(200);
  for (const std::size_t target : {200U, 2000U, 20000U}) {
    const Simplified few = simplify(shape.mesh(), {.clustering = GetParam(), .target = target});
    EXPECT_LE(few.triangles.size() / 3, target);
    EXPECT_GE(static_cast<double>(few.triangles.size()) / 3,
              (GetParam() == Clustering::grid ? 0.6 : 0.9) * static_cast<double>(target));
  }
}

TEST_P(Simplify, KeepsAClosedMeshClosedAndManifold) {
  const Shape shape = torus(200);
  for (const std::size_t target : {300U, 3000U, 10000U}) {
    const Simplified few = simplify(shape.mesh(), {.clustering = GetParam(), .target = target});
    const EdgeFaults faults = edge_faults(few.triangles);
    EXPECT_EQ(faults.boundary, 0U);
    EXPECT_EQ(faults.non_manifold, 0U);
  }
}

TEST_P(Simplify, HasNoTriangleTwiceOrWithoutThreeCorners) {
  const Shape shape = torus(150);
  const Simplified few = simplify(shape.mesh(), {.clustering = GetParam(), .target = 1000});
  std::set<std::array<std::uint32_t, 3>> seen;
  for (std::size_t t = 0; t < few.triangles.size(); t += 3) {
    std::array<std::uint32_t, 3> corners{few.triangles[t], few.triangles[t + 1], few.triangles[t + 2]};
    std::sort(corners.begin(), corners.end());
    EXPECT_TRUE(corners[0] < corners[1] && corners[1] < corners[2] && corners[2] < few.positions.size() / 3);
    EXPECT_TRUE(seen.insert(corners).second);
  }
}

TEST_P(Simplify, IsTheSameForAnyNumberOfThreadsAndAtAnyScale) {
  const Shape shape = torus(300);
  const SimplifyOptions options{.clustering = GetParam(), .target = 5000, .threads = 1};
  const Simplified one = simplify(shape.mesh(), options);
  SimplifyOptions parallel = options;
  parallel.threads = 4;
  EXPECT_EQ(simplify(shape.mesh(), parallel).positions, one.positions);
  Shape larger = shape;
  for (float& number : larger.positions) number *= 1024;
  Simplified scaled = simplify(larger.mesh(), options);
  for (float& number : scaled.positions) number /= 1024;
  EXPECT_EQ(scaled.positions, one.positions);
  EXPECT_EQ(scaled.triangles, one.triangles);
}

TEST_P(Simplify, ReducesPointsToATarget) {
  const Shape shape = sphere(30000);
  const Simplified few = simplify({shape.points()}, {.clustering = GetParam(), .target = 2000});
  const std::size_t count = few.positions.size() / 3;
  EXPECT_LE(count, 2000U);
  EXPECT_GE(count, GetParam() == Clustering::grid ? 1200U : 1950U);
  EXPECT_TRUE(few.triangles.empty());
  for (std::size_t i = 0; i < few.positions.size(); i += 3)
    EXPECT_NEAR(std::hypot(few.positions[i], few.positions[i + 1], few.positions[i + 2]), 1, 0.02);
}

TEST(Simplified, ByAnErrorHasMoreTrianglesTheSmallerItIs) {
  const Shape shape = torus(200);
  std::size_t last = 0;
  for (const float threshold : {1e-2F, 3e-3F, 1e-3F}) {
    const std::size_t count = simplify(shape.mesh(), {.threshold = threshold}).triangles.size();
    EXPECT_GT(count, last);
    last = count;
  }
}

// Returns the root mean square distance of the points from the surface of a torus without bumps.
double error_of(const Simplified& few) {
  double sum = 0;
  for (std::size_t t = 0; t < few.triangles.size(); t += 3) {
    double p[3] = {};
    for (std::size_t i = 0; i < 9; ++i) p[i % 3] += few.positions[3 * few.triangles[t + i / 3] + i % 3] / 3.0;
    const double y = 0.8 * p[1] + 0.6 * p[2], z = -0.6 * p[1] + 0.8 * p[2];
    const double distance = std::hypot(std::hypot(p[0], y) - 1, z) - 0.4;
    sum += distance * distance;
  }
  return std::sqrt(sum / (static_cast<double>(few.triangles.size()) / 3));
}

TEST(Simplified, ByQuadricsIsCloserThanByCentroids) {
  const Shape shape = torus(200, 0);
  const Simplified best = simplify(shape.mesh(), {.target = 2000});
  const Simplified means = simplify(shape.mesh(), {.representative = Representative::centroid, .target = 2000});
  EXPECT_LT(error_of(best), 0.7 * error_of(means));
}

TEST(Simplified, ByTheTreeIsCloserThanByTheGrid) {
  const Shape shape = torus(200, 0);
  const Simplified tree = simplify(shape.mesh(), {.target = 1000});
  const Simplified grid = simplify(shape.mesh(), {.clustering = Clustering::grid, .target = 1000});
  EXPECT_LT(error_of(tree), 0.95 * error_of(grid));
}

TEST(Simplified, CarriesAttributes) {
  Shape shape = torus(100);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const bool right = shape.positions[3 * i] > 0;
    shape.colours.insert(shape.colours.end(), {static_cast<std::uint8_t>(right ? 200 : 100), 7, 255});
    shape.texcoords.insert(shape.texcoords.end(), {right ? 0.75F : 0.25F, 0.5F});
  }
  const PointSet points{shape.positions, shape.normals, shape.colours, shape.texcoords};
  for (const Mesh& mesh : {Mesh{points, shape.triangles}, Mesh{points, {}}}) {
    const Simplified few = simplify(mesh, {.target = 800});
    const std::size_t count = few.positions.size() / 3;
    ASSERT_EQ(few.colours.size(), 3 * count);
    ASSERT_EQ(few.texcoords.size(), 2 * count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_TRUE(few.texcoords[2 * i] == 0.25F || few.texcoords[2 * i] == 0.75F);  // from one sample, not a mean
      if (std::abs(few.positions[3 * i]) < 0.5F) continue;
      EXPECT_EQ(few.colours[3 * i], few.positions[3 * i] > 0 ? 200 : 100);
      EXPECT_EQ(few.colours[3 * i + 2], 255);
      const float* const normal = &few.normals[3 * i];
      EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-5);
    }
  }
}

TEST(Simplified, SaysWhatStandsForASample) {
  const Shape shape = torus(100);
  const Simplified few = simplify(shape.mesh(), {.target = 1000});
  ASSERT_EQ(few.representatives.size(), shape.size());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const std::uint32_t r = few.representatives[i];
    if (r == none) continue;
    ASSERT_LT(r, few.positions.size() / 3);
    const auto [x, y, z] = shape.position(i);
    EXPECT_LT(std::hypot(x - few.positions[3 * r], y - few.positions[3 * r + 1], z - few.positions[3 * r + 2]), 0.4F);
  }
}

TEST(Simplified, WithoutNormalsUsesThoseOfItsTriangles) {
  const Shape shape = torus(100, 0);
  const Simplified few = simplify({{.positions = shape.positions}, shape.triangles}, {.target = 2000});
  EXPECT_LT(error_of(few), 0.01);
  EXPECT_EQ(few.normals.size(), few.positions.size());
}

// Two tetrahedra share an edge.
TEST(Simplified, CutsSheetsThatTouch) {
  const std::vector<float> positions{0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1, -1, 0, 0, -1, -1, 1};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2, 0, 1, 4, 0, 4, 5, 0, 5, 1, 1, 5, 4};
  const Mesh mesh{{.positions = positions}, triangles};
  const Simplified joined = simplify(mesh, {.target = 100, .cut = false});
  EXPECT_EQ(edge_faults(joined.triangles).non_manifold, 1U);
  const Simplified apart = simplify(mesh, {.target = 100});
  EXPECT_EQ(apart.triangles.size(), triangles.size());
  EXPECT_EQ(edge_faults(apart.triangles).non_manifold, 0U);
  EXPECT_EQ(apart.positions.size(), 3U * 8);
}

// Makes n times n vertices over the unit square. `place` moves their coordinates; `height` gives the third coordinate.
template <typename Place, typename Height>
Shape sheet(std::uint32_t n, const Place& place, const Height& height) {
  Shape shape;
  for (std::uint32_t i = 0; i < n * n; ++i) {
    const auto last = static_cast<float>(n - 1);
    const std::uint32_t row = i / n;
    const float x = place(static_cast<float>(i % n) / last), y = place(static_cast<float>(row) / last);
    shape.positions.insert(shape.positions.end(), {x, y, height(x, y)});
    if (i % n < n - 1 && row < n - 1)
      shape.triangles.insert(shape.triangles.end(), {i, i + 1, i + n + 1, i, i + n + 1, i + n});
  }
  return shape;
}

TEST(Simplified, OfAnOpenMeshKeepsItsBorderOnly) {
  const Shape shape = sheet(
      40, [](float x) { return x; }, [](float, float) { return 0.0F; });
  const Simplified few = simplify({{.positions = shape.positions}, shape.triangles}, {.target = 200});
  EXPECT_GT(few.triangles.size() / 3, 100U);
  const EdgeFaults faults = edge_faults(few.triangles);
  EXPECT_EQ(faults.non_manifold, 0U);
  EXPECT_GT(faults.boundary, 10U);
  for (std::size_t i = 2; i < few.positions.size(); i += 3) EXPECT_NEAR(few.positions[i], 0, 1e-5);
}

// On a plane, all errors are equal. There are more samples than one grid takes. Targets range from few clusters to
// almost all samples.
TEST(Simplified, OfAPlaneComesCloseToAnyTarget) {
  const Shape shape = sheet(
      200, [](float x) { return x; }, [](float, float) { return 0.0F; });
  for (const std::size_t target : {10U, 100U, 1000U, 10000U, 40000U, 70000U}) {
    const Simplified few = simplify({{.positions = shape.positions}, shape.triangles}, {.target = target});
    EXPECT_LE(few.triangles.size() / 3, target);
    EXPECT_GE(static_cast<double>(few.triangles.size()) / 3, 0.8 * static_cast<double>(target)) << target;
  }
}

// The cells of a grid have one size. A cell with too many samples has another grid below it.
TEST(Simplified, DividesDenseCornersDeeper) {
  const auto square = [](float x) { return x * x * x * x; };
  const auto waves = [](float x, float y) {
    return 0.1F * std::sin(400 * x) * x * (1 - std::min(1.0F, 20 * std::hypot(x, y)));
  };
  const Shape shape = sheet(150, square, [&](float x, float y) { return std::hypot(x, y) < 0.05F ? waves(x, y) : 0; });
  const Mesh mesh{{.positions = shape.positions}, shape.triangles};
  const Simplified few = simplify(mesh, {.target = 3000, .threads = 1});
  EXPECT_GE(few.triangles.size() / 3, 2700U);
  std::size_t dense = 0;
  for (std::size_t i = 0; i < few.positions.size(); i += 3)
    dense += std::hypot(few.positions[i], few.positions[i + 1]) < 0.06F ? 1 : 0;
  EXPECT_GT(dense, few.positions.size() / 3 / 20);
  EXPECT_EQ(simplify(mesh, {.target = 3000, .threads = 4}).positions, few.positions);
}

TEST(Simplified, OfManySamplesAtFewPlacesHasThese) {
  Shape shape;
  for (int i = 0; i < 20000; ++i) {
    const auto place = static_cast<float>(i % 40);
    shape.positions.insert(shape.positions.end(), {place, place * place / 40, 0});
    shape.normals.insert(shape.normals.end(), {0, 0, 1});
  }
  const Simplified all = simplify({shape.points()}, {.target = 19999});
  EXPECT_EQ(all.positions.size() / 3, 40U);
  EXPECT_LE(simplify({shape.points()}, {.target = 10}).positions.size() / 3, 10U);
}

TEST(Simplified, IgnoresTrianglesWithoutArea) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 0, 1, 0, 1, 3};
  const Simplified few = simplify({{.positions = positions}, triangles}, {.target = 100});
  EXPECT_EQ(few.triangles.size() / 3, 2U);
  for (const float number : few.positions) EXPECT_TRUE(std::isfinite(number));
}

}  // namespace
}  // namespace glark::vstree::test
