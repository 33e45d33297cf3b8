// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include <glark/depth.h>

#include "tests/depth/meshes.h"

namespace glark::depth {
namespace {

using testing::Mesh;

struct Curvatures {
  std::vector<float> greater;
  std::vector<float> lesser;
};

Curvatures curvatures_of(const Mesh& mesh, bool with_normals = true) {
  Tagger tagger(mesh.vertices(), mesh.triangles, 6);
  Curvatures result{std::vector<float>(mesh.vertices()), std::vector<float>(mesh.vertices())};
  tagger.principal_curvatures(mesh.positions,
                              with_normals ? std::span<const float>(mesh.normals) : std::span<const float>(),
                              result.greater, result.lesser);
  return result;
}

TEST(Curvature, OfASphereIsOneByItsRadius) {
  const Mesh mesh = testing::make_sphere(2, 48);
  const Curvatures found = curvatures_of(mesh);
  for (std::size_t i = 0; i < mesh.vertices(); ++i) {
    EXPECT_NEAR(found.greater[i], 0.5F, 0.01F) << i;
    EXPECT_NEAR(found.lesser[i], 0.5F, 0.01F) << i;
  }
}

TEST(Curvature, OfACylinderIsNoneAlongIt) {
  const Mesh mesh = testing::make_cylinder(0.5F, 48);
  const Curvatures found = curvatures_of(mesh);
  for (std::size_t i = 0; i < mesh.vertices(); ++i) {
    EXPECT_NEAR(found.greater[i], 2.0F, 0.02F) << i;
    EXPECT_NEAR(found.lesser[i], 0.0F, 0.02F) << i;
  }
}

TEST(Curvature, OfATorusHasTheSignOfItsSide) {
  const std::uint32_t n = 96;
  const Mesh mesh = testing::make_torus(3, 1, n);
  const Curvatures found = curvatures_of(mesh);
  for (std::size_t i = 0; i < mesh.vertices(); ++i) {
    const std::size_t row = i / (n + 1);
    const float v = testing::turn * static_cast<float>(row) / n;
    EXPECT_NEAR(found.greater[i], 1.0F, 0.02F) << i;
    EXPECT_NEAR(found.lesser[i], std::cos(v) / (3 + std::cos(v)), 0.02F) << i;
  }
}

TEST(Curvature, NormalsOfTheFacesStandInForThoseThatAreMissing) {
  const std::uint32_t n = 64;
  Mesh mesh = testing::make_sphere(1, n);
  const Curvatures found = curvatures_of(mesh, false);
  for (std::uint32_t j = 2; j < n - 1; ++j) {
    for (std::uint32_t i = 2; i < n - 1; ++i) EXPECT_NEAR(found.greater[j * (n + 1) + i], 1.0F, 0.05F);
  }
  std::fill(mesh.normals.begin(), mesh.normals.end(), 0.0F);
  EXPECT_EQ(curvatures_of(mesh).greater, found.greater);
}

TEST(Curvature, OfAMirroredSurfaceIsNegative) {
  Mesh mesh = testing::make_sphere(2, 32);
  for (float& component : mesh.normals) component = -component;
  const Curvatures found = curvatures_of(mesh);
  EXPECT_NEAR(found.greater[500], -0.5F, 0.02F);
}

// The sagitta is k L^2 / 8 = 0.5 * L^2 / 8. Each level divides it by four.
TEST(Curvature, TagHalvesTheSegmentsUntilTheArcIsNear) {
  const Mesh mesh = testing::make_cylinder(0.5F, 16);
  Tagger tagger(mesh.vertices(), mesh.triangles, 11);
  std::vector<float> tags(mesh.vertices());
  const std::size_t vertex = 8 * 17 + 8;
  const float dx = 2 * 0.5F * std::sin(testing::turn / 32);
  const float longest = std::hypot(dx, 0.25F);
  const float sagitta = 2 * longest * longest / 8;
  tagger.by_curvature(mesh.positions, mesh.normals, sagitta / 16, tags);
  EXPECT_NEAR(tags[vertex], 2.0F, 0.02F);
  tagger.by_curvature(mesh.positions, mesh.normals, sagitta / 64, tags);
  EXPECT_NEAR(tags[vertex], 3.0F, 0.02F);
  tagger.by_curvature(mesh.positions, mesh.normals, 2 * sagitta, tags);
  EXPECT_EQ(tags[vertex], 0.0F);
}

TEST(Curvature, ToleranceInPixelsFollowsTheEye) {
  const Mesh mesh = testing::make_sphere(1, 24);
  Tagger tagger(mesh.vertices(), mesh.triangles, 11);
  std::vector<float> near(mesh.vertices());
  std::vector<float> far(mesh.vertices());
  tagger.by_curvature(mesh.positions, mesh.normals, View{.eye = {10, 0, 0}}, 0.01F, near);
  tagger.by_curvature(mesh.positions, mesh.normals, View{.eye = {160, 0, 0}}, 0.01F, far);
  const std::size_t vertex = 12 * 25;  // (1, 0, 0)
  EXPECT_NEAR(near[vertex] - far[vertex], 0.5F * std::log2(159.0F / 9), 1e-3F);
}

TEST(Curvature, DegenerateTrianglesAndIsolatedVerticesHaveNone) {
  Mesh mesh = testing::make_sphere(1, 24);
  const std::vector<float> before = curvatures_of(mesh).greater;
  mesh.triangles.insert(mesh.triangles.end(), {7, 7, 7, 7, 8, 8, 3, 4, 3});
  mesh.positions.insert(mesh.positions.end(), {5, 5, 5});
  mesh.normals.insert(mesh.normals.end(), {0, 0, 0});
  const std::vector<float> after = curvatures_of(mesh).greater;
  EXPECT_EQ(after.back(), 0.0F);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
}

TEST(Curvature, StaysFiniteWhereAllIsDegenerate) {
  Mesh mesh;
  mesh.positions = {0, 0, 0, 1e30F, 0, 0, 0, 1e30F, 1e-30F, 0, 0, 0};
  mesh.triangles = {0, 1, 2, 0, 3, 0, 3, 1, 0, 2, 1, 0, 0, 1, 2};
  mesh.normals.assign(12, 0);
  Tagger tagger(4, mesh.triangles, 6);
  std::vector<float> tags(4, -1.0F);
  tagger.by_curvature(mesh.positions, mesh.normals, 1e-20F, tags);
  for (float tag : tags) EXPECT_TRUE(tag >= 0 && tag <= 6) << tag;
}

}  // namespace
}  // namespace glark::depth
