// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples whose density varies: sparse parts stay, and are as near to the surface as their samples allow.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/reconstruct/statues.h"

namespace glark::reconstruct::test {
namespace {

TEST(UnevenDensity, NothingIsDroppedForBeingSparse) {
  for (const auto& [ratio, seed, most] : {std::tuple{10.0, 1U, 0.004}, {100.0, 2U, 0.004}, {1000.0, 1U, 0.006}}) {
    SCOPED_TRACE(std::to_string(ratio) + ":1, statue " + std::to_string(seed));
    const shapes::Statue statue(seed);
    const shapes::Cloud cloud = cloud_of(statue, seed, {.samples = 40000, .density_ratio = ratio});
    const Reconstructed mesh = reconstruct(points_of(cloud), {.levels = 1});
    expect_manifold(mesh);
    EXPECT_EQ(mesh.left_out, 0U);
    EXPECT_EQ(topology_of(mesh).parts, 1U);
    const StatueDistance distance = distance_from(statue, mesh);
    EXPECT_LT(distance.to_statue, most);
    EXPECT_LT(distance.from_statue, most);
  }
}

TEST(UnevenDensity, DependsOnNoThreads) {
  const shapes::Statue statue(3);
  const shapes::Cloud cloud = cloud_of(statue, 3, {.samples = 20000, .density_ratio = 300, .outliers = 0.02});
  const Reconstructed one = reconstruct(points_of(cloud), {.levels = 1, .threads = 1});
  const Reconstructed several = reconstruct(points_of(cloud), {.levels = 1, .threads = 4});
  EXPECT_EQ(one.positions, several.positions);
  EXPECT_EQ(one.triangles, several.triangles);
  EXPECT_EQ(one.outliers, several.outliers);
}

// The filled parts get the colours of the samples around.
TEST(UnevenDensity, SparsePartsKeepTheirColours) {
  const shapes::Statue statue(4);
  const shapes::Cloud cloud = cloud_of(statue, 4, {.samples = 20000, .density_ratio = 1000});
  std::vector<std::uint8_t> colours;
  for (std::size_t i = 0; i < cloud.size(); ++i) colours.insert(colours.end(), {200, 100, 50});
  const Reconstructed mesh =
      reconstruct({.positions = cloud.positions, .normals = cloud.normals, .colours = colours}, {.levels = 0});
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.colours.size(); i += 3) {
    ASSERT_NEAR(mesh.colours[i], 200, 1);
    ASSERT_NEAR(mesh.colours[i + 1], 100, 1);
    ASSERT_NEAR(mesh.colours[i + 2], 50, 1);
  }
}

}  // namespace
}  // namespace glark::reconstruct::test
