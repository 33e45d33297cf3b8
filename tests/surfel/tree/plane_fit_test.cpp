// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/plane_fit.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::surfel::test {
namespace {

// A grid in the plane through the origin with the axes u and v.
std::vector<Surfel> grid(Vector u, Vector v, Vector normal) {
  std::vector<Surfel> surfels;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -3; j <= 3; ++j) {
      surfels.push_back({u * static_cast<float>(i) + v * static_cast<float>(j), 0, normal, 0});
    }
  }
  return surfels;
}

void expect_near(Vector a, Vector b) {
  EXPECT_NEAR(a.x, b.x, 1e-6F);
  EXPECT_NEAR(a.y, b.y, 1e-6F);
  EXPECT_NEAR(a.z, b.z, 1e-6F);
}

TEST(SurfelPlaneFit, NormalIsTheMeanOfNormals) {
  std::vector<Surfel> surfels = grid({1, 0, 0}, {0, 1, 0}, {0, 0.6F, 0.8F});
  for (std::size_t i = 0; i < surfels.size(); i += 2) surfels[i].normal = {0, 0.6F, 0.8F};
  expect_near(fit_plane(surfels).normal, {0, 0.6F, 0.8F});
}

TEST(SurfelPlaneFit, NormalIsTheDirectionOfLeastVarianceWithoutNormals) {
  const std::vector<Surfel> surfels = grid({0, 0.8F, -0.6F}, {1, 0, 0}, {});
  expect_near(fit_plane(surfels).normal, {0, 0.6F, 0.8F});
}

TEST(SurfelPlaneFit, OpposedNormalsAreIgnored) {
  std::vector<Surfel> surfels = grid({1, 0, 0}, {0, 0, 1}, {1, 0, 0});
  surfels.pop_back();
  for (std::size_t i = 0; i < surfels.size(); i += 2) surfels[i].normal = {-1, 0, 0};
  expect_near(fit_plane(surfels).normal, {0, 1, 0});
}

TEST(SurfelPlaneFit, SinglePointsHaveAPlane) {
  const std::vector<Surfel> surfels(3, Surfel{{1, 2, 3}, 0, {}, 0});
  const Plane plane = fit_plane(surfels);
  expect_near(plane.centre, {1, 2, 3});
  EXPECT_NEAR(length(plane.normal), 1, 1e-6F);
}

TEST(SurfelPlaneFit, MeanSpacingOfAGridIsItsStep) {
  const std::vector<Surfel> surfels = grid({0.5F, 0, 0}, {0, 0.5F, 0}, {0, 0, 1});
  EXPECT_NEAR(mean_spacing(surfels, fit_plane(surfels)), 0.5F, 0.01F);
}

}  // namespace
}  // namespace glark::surfel::test
