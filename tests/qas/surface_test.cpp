// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

Surface updated(const ControlMesh& mesh, const Options& options = {}) {
  Surface surface(mesh.view(), options);
  surface.update(mesh.positions);
  return surface;
}

std::vector<float> numbers_of(const Surface& surface) {
  std::vector<Corner> corners(surface.corner_count());
  surface.write_corners(corners);
  std::vector<float> numbers;
  for (const Corner& corner : corners) {
    for (const auto& triple : {corner.position, corner.edge_position, corner.normal, corner.edge_normal})
      numbers.insert(numbers.end(), triple.begin(), triple.end());
  }
  return numbers;
}

TEST(Surface, OfATetrahedronIsWorkedByHand) {
  const ControlMesh mesh{
      "tetrahedron", {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  const Surface surface = updated(mesh);
  // For valence 3, beta is 3/16, and the limit weighs a neighbour 1/5.
  EXPECT_NEAR(surface.limit_positions()[0].x, 0.4F - 0.2F, 1e-6);
  EXPECT_NEAR(surface.limit_normals()[surface.patches()[0].normals[0]].x, std::sqrt(1.0F / 3), 1e-6);
}

TEST(Surface, HasASplineForItsBoundary) {
  const ControlMesh mesh{"strip", {0, 0, 0, 6, 0, 0, 12, 6, 0, 0, 9, 9, 6, 9, 9}, {0, 1, 3, 1, 4, 3, 1, 2, 4}};
  const Surface surface = updated(mesh);
  EXPECT_NEAR(surface.limit_positions()[1].x, (0 + 4 * 6 + 12) / 6.0, 1e-6);
  EXPECT_NEAR(surface.limit_positions()[1].y, (0 + 4 * 0 + 6) / 6.0, 1e-6);
}

// The edge of a drum's lid is round. On this edge, lid and wall have the same points, but different normals.
TEST(Surface, HasTwoNormalsAlongACrease) {
  const ControlMesh mesh = drum(12);
  const Surface surface = updated(mesh);
  const ControlMesh smooth{"smooth", mesh.positions, mesh.triangles};
  int sharp = 0;
  for (std::size_t t = 0; t < surface.patches().size(); ++t) {
    for (std::size_t u = 0; u < t; ++u) {
      for (std::size_t i = 3; i < 6; ++i) {
        for (std::size_t j = 3; j < 6; ++j) {
          const Patch &a = surface.patches()[t], &b = surface.patches()[u];
          if (a.positions[i] == b.positions[j] && a.normals[i] != b.normals[j]) ++sharp;
        }
      }
    }
  }
  EXPECT_EQ(sharp, 24);
  EXPECT_EQ(mesh.creases.size(), 48U);
  EXPECT_NE(numbers_of(surface), numbers_of(updated(smooth)));
}

TEST(Surface, IsTheSameOnAnyNumberOfThreads) {
  const ControlMesh mesh = shaken(densified(drum(12), 3), 0.001);
  for (const unsigned splits : {0U, 1U}) {
    const auto alone = numbers_of(updated(mesh, {.splits = splits, .threads = 1}));
    EXPECT_EQ(alone, numbers_of(updated(mesh, {.splits = splits, .threads = 3})));
    EXPECT_EQ(alone, numbers_of(updated(mesh, {.splits = splits})));
  }
}

TEST(Surface, ScalesWithItsMeshBitByBit) {
  ControlMesh mesh = shaken(blocks(), 0.01);
  std::vector<float> before = numbers_of(updated(mesh));
  for (float& value : mesh.positions) value *= 0x1p60F;
  const std::vector<float> after = numbers_of(updated(mesh));
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_EQ(i % 12 < 6 ? before[i] * 0x1p60F : before[i], after[i]) << i;
}

TEST(Surface, ForgetsTheFrameBefore) {
  const ControlMesh mesh = shaken(blocks(), 0.01);
  Surface surface = updated(mesh);
  const std::vector<float> first = numbers_of(surface);
  surface.update(blocks().positions);
  EXPECT_NE(numbers_of(surface), first);
  surface.update(mesh.positions);
  EXPECT_EQ(numbers_of(surface), first);
}

// The four patches have the corners of the limit step, and more points between them.
TEST(Surface, SplitHasTheSamePoints) {
  const ControlMesh mesh = blocks();
  const Surface surface = updated(mesh), split = updated(mesh, {.splits = 1});
  for (std::size_t t = 0; t < surface.patches().size(); ++t) {
    const Sample corner = surface.evaluate(t, {0, 1, 0}), same = split.evaluate(4 * t + 1, {0, 1, 0});
    const Sample middle = surface.evaluate(t, {0, 0.5F, 0.5F}), there = split.evaluate(4 * t + 3, {0, 1, 0});
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_NEAR(corner.position[k], same.position[k], 1e-6);
      ASSERT_NEAR(middle.position[k], there.position[k], 1e-6);
      ASSERT_NEAR(corner.normal[k], same.normal[k], 2e-6);
      ASSERT_NEAR(middle.normal[k], there.normal[k], 2e-6);
    }
    const auto [a, b] = split.corner_vertices()[3 * (4 * t + 3) + 1];  // the middle of edge 12
    EXPECT_EQ(std::min(a, b), std::min(mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2]));
    EXPECT_EQ(std::max(a, b), std::max(mesh.triangles[3 * t + 1], mesh.triangles[3 * t + 2]));
  }
}

}  // namespace
}  // namespace glark::qas::test
