// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Samples that lie on no surface are found, counted and left out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

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

// A round, wavy cover of one sheet with a wide box around it. Its boundary is where outliers lie on the planes of samples.
struct Cover {
  std::vector<float> positions, normals;
  double diagonal = 0;
};

double height_of_cover(double x, double y) { return 0.1 * std::sin(3 * x) * std::cos(4 * y); }

Cover cover_with_outliers(unsigned seed, double noise, double share) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::normal_distribution<double> normal;
  Cover cover;
  cover.diagonal = 2.9;
  const auto add = [](std::vector<float>& to, double x, double y, double z) {
    to.insert(to.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  };
  while (cover.positions.size() < 3 * samples) {
    const double x = place(random), y = place(random);
    if (x * x + y * y > 1) continue;
    const double dx = 0.3 * std::cos(3 * x) * std::cos(4 * y), dy = -0.4 * std::sin(3 * x) * std::sin(4 * y);
    const double length = std::hypot(dx, dy, 1.0), off = noise * cover.diagonal;
    add(cover.positions, x + off * normal(random), y + off * normal(random),
        height_of_cover(x, y) + off * normal(random));
    add(cover.normals, -dx / length, -dy / length, 1 / length);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(share * samples); ++i) {
    add(cover.positions, place(random), place(random), 0.6 * place(random));
    const double x = normal(random), y = normal(random), z = normal(random), length = std::hypot(x, y, z);
    add(cover.normals, x / length, y / length, z / length);
  }
  return cover;
}

void expect_near(const Cover& cover, const Reconstructed& mesh, double noise) {
  expect_manifold(mesh);
  EXPECT_EQ(topology_of(mesh).parts, 1U);
  double most = 0, sum = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const auto x = static_cast<double>(mesh.positions[i]), y = static_cast<double>(mesh.positions[i + 1]);
    const double up = std::abs(static_cast<double>(mesh.positions[i + 2]) - height_of_cover(x, y));
    const double off = std::max(up, std::hypot(x, y) - 1);
    most = std::max(most, off);
    sum += off * off;
  }
  const double rms = std::sqrt(3 * sum / static_cast<double>(mesh.positions.size()));
  EXPECT_LT(rms / cover.diagonal, std::max(0.002, 1.5 * noise));
  EXPECT_LT(most, 2.5 * static_cast<double>(mesh.node_side));
}

// An outlier beside the boundary has only samples of the surface as neighbours, and lies on their planes by chance. An
// outlier in the surface that faces the other way looks like the other side of a thin sheet.
TEST(Outliers, MakeNoFlapsAtTheBoundaryOfASheet) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    for (const auto& [share, noise] : {std::pair{0.01, 0.001}, {0.05, 0.0}, {0.05, 0.002}, {0.2, 0.001}}) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(share) + ", noise " + std::to_string(noise));
      const Cover cover = cover_with_outliers(seed, noise, share);
      expect_near(cover, reconstruct({.positions = cover.positions, .normals = cover.normals}, {.levels = 1}), noise);
    }
  }
}

// A few of many random samples lie on a plane, and their estimated normals agree. Most of their neighbours have no
// support.
TEST(Outliers, MakeNoSheetsByChance) {
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    for (const auto& [share, noise] : {std::pair{0.05, 0.0}, {0.1, 0.0}, {0.1, 0.001}}) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(share) + ", noise " + std::to_string(noise));
      const Cover cover = cover_with_outliers(seed, noise, share);
      expect_near(cover, reconstruct({.positions = cover.positions}, {.levels = 1}), noise);
    }
  }
}

// Beside a dense part, the nearest neighbours of sparse samples are dense ones, which say nothing about sparse parts.
TEST(Outliers, AreNoSparseSamplesBesideADensePart) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const Shape dense = sphere(60000);
    Shape shape;
    for (std::size_t i = 0; i < dense.positions.size(); i += 3) {
      if (dense.positions[i] < 0 && share(random) > 0.01) continue;
      shape.positions.insert(shape.positions.end(), &dense.positions[i], &dense.positions[i] + 3);
      shape.normals.insert(shape.normals.end(), &dense.normals[i], &dense.normals[i] + 3);
    }
    const Reconstructed mesh = reconstruct(shape.points(), {.levels = 0});
    EXPECT_EQ(mesh.outliers, 0U);
    EXPECT_EQ(topology_of(mesh).parts, 1U);
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

TEST(Outliers, AreNamed) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Cover cover = cover_with_outliers(seed, 0, 0.02);
    const std::vector<std::uint32_t> found = find_outliers({.positions = cover.positions, .normals = cover.normals});
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    const auto real = std::count_if(found.begin(), found.end(), [](std::uint32_t i) { return i >= samples; });
    EXPECT_GT(real, static_cast<std::ptrdiff_t>(0.9 * 0.02 * samples));
    EXPECT_LT(static_cast<double>(found.size()) - static_cast<double>(real), 0.001 * samples);
  }
  EXPECT_TRUE(find_outliers({}).empty());
  EXPECT_THROW(find_outliers({.positions = std::vector<float>(4)}), vstree::Error);
}

// Fog has no surface, so there is nothing from which a sample could lie apart.
TEST(Outliers, AreNotMostOfTheSamples) {
  const shapes::Cloud cloud = shapes::fog(3, 5000);
  const Reconstructed mesh = reconstruct(points_of(cloud), {.levels = 0});
  EXPECT_LT(mesh.outliers, 50U);
}

}  // namespace
}  // namespace glark::reconstruct::test
