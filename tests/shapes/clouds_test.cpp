// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The generated clouds are what their options say.
#include "tests/shapes/clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glark::shapes {
namespace {

Point point_at(const Cloud& cloud, std::size_t i) {
  return {static_cast<double>(cloud.positions[3 * i]), static_cast<double>(cloud.positions[3 * i + 1]),
          static_cast<double>(cloud.positions[3 * i + 2])};
}

double rms_of(const Statue& statue, const Cloud& cloud) {
  double sum = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) sum += std::pow(statue.distance(point_at(cloud, i)), 2);
  return std::sqrt(sum / static_cast<double>(cloud.size()));
}

TEST(Clouds, SamplesLieOnTheStatue) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    const Statue statue(seed);
    EXPECT_LT(rms_of(statue, cloud_of(statue, seed, {.samples = 2000})), 1e-4);
  }
}

TEST(Clouds, NoiseIsAsLargeAsAskedFor) {
  const Statue statue(1);
  EXPECT_NEAR(rms_of(statue, cloud_of(statue, 1, {.samples = 4000, .noise = 0.004})), 0.004, 0.0005);
}

TEST(Clouds, DensityFallsFromFeetToHead) {
  const Statue statue(2);
  const Cloud cloud = cloud_of(statue, 2, {.samples = 5000, .density_ratio = 1000});
  std::size_t below = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) below += point_at(cloud, i)[2] < 0.6 ? 1 : 0;
  EXPECT_GT(below, cloud.size() * 3 / 4);
}

TEST(Clouds, OutliersAreTheirShare) {
  const Statue statue(3);
  const Cloud cloud = cloud_of(statue, 3, {.samples = 5000, .outliers = 0.2});
  std::size_t off = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) off += std::abs(statue.distance(point_at(cloud, i))) > 1e-3 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(off), 1000, 120);
}

TEST(Clouds, LayersAreApart) {
  const Statue statue(4);
  const double off = rms_of(statue, cloud_of(statue, 4, {.samples = 4000, .layers = 0.02}));
  EXPECT_GT(off, 0.004);
  EXPECT_LT(off, 0.02);
}

}  // namespace
}  // namespace glark::shapes
