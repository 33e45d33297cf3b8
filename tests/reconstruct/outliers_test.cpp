// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples that lie on no surface are found, counted and left out.
#include <gtest/gtest.h>

#include <utility>

#include "tests/reconstruct/statues.h"

namespace glark::reconstruct::test {
namespace {

constexpr std::size_t samples = 40000;

TEST(Outliers, AreFoundAndDoNotChangeTheSurface) {
  for (const auto& [share, noise] : {std::pair{0.01, 0.003}, {0.05, 0.0}, {0.05, 0.003}, {0.2, 0.0}, {0.2, 0.003}}) {
    SCOPED_TRACE(std::to_string(share) + ", noise " + std::to_string(noise));
    const shapes::Statue statue(5);
    const shapes::Cloud cloud =
        cloud_of(statue, 5, {.samples = samples, .noise = noise * statue.diagonal(), .outliers = share});
    const Reconstructed mesh = reconstruct(points_of(cloud), {.levels = 1});
    EXPECT_GT(mesh.outliers, static_cast<std::size_t>(0.8 * share * samples));
    EXPECT_LT(mesh.outliers, static_cast<std::size_t>(1.1 * share * samples));
    const StatueDistance distance = distance_from(statue, mesh);
    EXPECT_LT(distance.to_statue, std::max(0.0015, 1.5 * noise));
    EXPECT_LT(distance.from_statue, std::max(0.0015, 1.5 * noise));
    expect_manifold(mesh);
  }
}

TEST(Outliers, ACleanCloudHasNone) {
  for (const unsigned seed : {1U, 6U}) {
    const shapes::Statue statue(seed);
    EXPECT_EQ(reconstruct(points_of(cloud_of(statue, seed, {.samples = samples})), {.levels = 0}).outliers, 0U);
  }
  EXPECT_EQ(reconstruct(torus(100).points(), {.levels = 0}).outliers, 0U);
}

TEST(Outliers, OneSampleFarAwayIsOne) {
  Shape shape = sphere(20000);
  shape.positions.insert(shape.positions.end(), {30, 0, 0});
  shape.normals.insert(shape.normals.end(), {1, 0, 0});
  EXPECT_EQ(reconstruct(shape.points(), {.levels = 0}).outliers, 1U);
}

// Fog has no surface, so there is nothing from which a sample could lie apart.
TEST(Outliers, AreNotMostOfTheSamples) {
  const shapes::Cloud cloud = shapes::fog(3, 5000);
  const Reconstructed mesh = reconstruct(points_of(cloud), {.levels = 0});
  EXPECT_LT(mesh.outliers, 50U);
}

}  // namespace
}  // namespace glark::reconstruct::test
