// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tests on real scans, if there are any in the folder GLARK_SCANS of CMake.
#include <glark/vstree.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/bench_points/measure/scan.h"
#include "tests/bench_points/measure/surface_distance.h"

namespace glark::vstree::test {
namespace {

class Scans : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(GLARK_SCANS)) GTEST_SKIP() << "there are no scans in " << GLARK_SCANS;
  }
};

TEST_F(Scans, OfAHeadSimplifyToAManifoldThatIsClose) {
  const bench::Scan scan = bench::read_scan(GLARK_SCANS, "igea");
  const PointSet points{.positions = scan.positions, .normals = scan.normals};
  const Simplified few = simplify({points, scan.triangles}, {.target = 25700});
  EXPECT_LE(few.triangles.size() / 3, 25700U);
  EXPECT_GE(few.triangles.size() / 3, 25300U);
  const bench::Edges edges = bench::edges_of(few.triangles);
  EXPECT_EQ(edges.boundary, 0U);
  EXPECT_EQ(edges.non_manifold, 0U);
  const std::vector<float> samples = bench::samples_of(scan.positions, scan.triangles, 50000);
  const double rms = bench::SurfaceDistance(few.positions, few.triangles).rms(samples);
  EXPECT_LE(rms / bench::diagonal_of(scan.positions), 1.3e-4);
}

TEST_F(Scans, HaveFewerLeavesThanAnOctree) {
  const bench::Scan scan = bench::sampled(bench::read_scan(GLARK_SCANS, "igea"), 1000000);
  const PointSet points{.positions = scan.positions, .normals = scan.normals};
  const auto leaves = static_cast<double>(Tree(points).leaf_count());
  EXPECT_LE(leaves, 0.68 * static_cast<double>(Tree(points, {.surface = false}).leaf_count()));
}

// Raw scans overlap and are noisy.
TEST_F(Scans, OfAStatueAreDividedAndSimplified) {
  const bench::Scan scan = bench::read_scan(GLARK_SCANS, "bunny_scans");
  const PointSet points{.positions = scan.positions, .normals = scan.normals};
  const Tree tree(points, {.threshold = 1e-3F});
  std::size_t samples = 0;
  for (const Node& node : tree.nodes()) samples += node.is_leaf() ? node.size() : 0;
  EXPECT_EQ(samples, scan.positions.size() / 3);
  EXPECT_LE(tree.bytes(), 16 * samples);
  EXPECT_LE(simplify({points}, {.target = 20000}).positions.size() / 3, 20000U);
}

TEST_F(Scans, HaveNormalsLikeTheirMeshes) {
  const bench::Scan scan = bench::read_scan(GLARK_SCANS, "bunny");
  const std::vector<float> normals = estimate_normals({.positions = scan.positions});
  std::size_t alike = 0;
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    const float cosine =
        normals[i] * scan.normals[i] + normals[i + 1] * scan.normals[i + 1] + normals[i + 2] * scan.normals[i + 2];
    alike += cosine > 0.8F ? 1 : 0;
  }
  const std::size_t points = normals.size() / 3;
  EXPECT_GT(static_cast<double>(alike), 0.97 * static_cast<double>(points));
}

}  // namespace
}  // namespace glark::vstree::test
