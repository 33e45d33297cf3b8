// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples that lie on no surface are found, counted and left out.
#include <gtest/gtest.h>

#include <random>
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

// The normals of sparse outliers are estimated from the same few samples, and so agree.
TEST(Outliers, AreFoundFarAwayAndWithoutNormals) {
  for (const unsigned seed : {2U, 7U}) {
    SCOPED_TRACE(seed);
    const shapes::Statue statue(seed);
    shapes::Cloud cloud = cloud_of(statue, seed, {.samples = samples});
    constexpr std::size_t far = 400;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-1, 2);
    for (std::size_t i = 0; i < 3 * far; ++i) {
      const double low = statue.low()[i % 3], high = statue.high()[i % 3];
      cloud.positions.push_back(static_cast<float>(low + place(random) * (high - low)));
    }
    const Reconstructed mesh = reconstruct({.positions = cloud.positions}, {.levels = 1});
    EXPECT_GT(mesh.outliers, 0.95 * far);
    EXPECT_LT(mesh.outliers, 1.1 * far);
    EXPECT_LT(distance_from(statue, mesh).to_statue, 0.0015);
    EXPECT_LT(distance_from(statue, mesh).from_statue, 0.0015);
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
