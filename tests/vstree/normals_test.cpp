// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

// Returns the least dot product of an estimated normal with the true normal.
float agreement(const std::vector<float>& estimated, const std::vector<float>& normals) {
  float least = 1;
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    least = std::min(least,
                     estimated[i] * normals[i] + estimated[i + 1] * normals[i + 1] + estimated[i + 2] * normals[i + 2]);
  }
  return least;
}

// Random samples of a closed box of side x side x thickness, one for each unit of area.
Shape thin_box(float side, float thickness, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share;
  Shape shape;
  const float size[3] = {side, side, thickness};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const float end : {0.0F, 1.0F}) {
      for (int i = 0; i < static_cast<int>(size[u] * size[v]); ++i) {
        float point[3] = {}, normal[3] = {};
        point[axis] = end * size[axis];
        point[u] = share(random) * size[u];
        point[v] = share(random) * size[v];
        normal[axis] = 2 * end - 1;
        shape.positions.insert(shape.positions.end(), point, point + 3);
        shape.normals.insert(shape.normals.end(), normal, normal + 3);
      }
    }
  }
  return shape;
}

// Returns the share of the estimated normals that are within 30 degrees of the true ones.
double share_right(const std::vector<float>& estimated, const std::vector<float>& normals) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); i += 3)
    right += estimated[i] * normals[i] + estimated[i + 1] * normals[i + 1] + estimated[i + 2] * normals[i + 2] > 0.866F;
  return 3 * static_cast<double>(right) / static_cast<double>(normals.size());
}

TEST(EstimatedNormals, PointOutOfClosedSurfaces) {
  for (const Shape& shape : {torus(150, 0), sphere(5000), sphere(5000, 0.005F)}) {
    EXPECT_GT(agreement(estimate_normals({.positions = shape.positions}), shape.normals), 0.8F);
  }
}

// The nearest neighbours of a sample lie on both sides of the wall, which is 1.5 to 3 spacings thick.
TEST(EstimatedNormals, PointOutOfThinWalls) {
  for (const float thickness : {1.5F, 2.0F, 3.0F}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::to_string(thickness) + " spacings, seed " + std::to_string(seed));
      const Shape shape = thin_box(100, thickness, seed);
      EXPECT_GT(share_right(estimate_normals({.positions = shape.positions}), shape.normals), 0.9);
    }
  }
}

// Noise of a tenth to a sixth of a spacing. Without a band as wide as the noise, 18 to 77 % of the normals are right.
TEST(EstimatedNormals, PointOutOfThinWallsWithNoise) {
  const std::pair<float, float> walls[] = {{1.5F, 0.1F}, {2.0F, 0.1F}, {2.0F, 0.16F}};
  for (const auto& [thickness, noise] : walls) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::to_string(thickness) + " spacings, noise " + std::to_string(noise) + ", seed " +
                   std::to_string(seed));
      Shape shape = thin_box(100, thickness, seed);
      std::mt19937 random(seed);
      std::normal_distribution<float> error(0, noise);
      for (float& coordinate : shape.positions) coordinate += error(random);
      EXPECT_GT(share_right(estimate_normals({.positions = shape.positions}), shape.normals), 0.85);
    }
  }
}

// Planes that join the two sides of a wall are found by the neighbours. Without that, .3 % of the normals are wrong.
TEST(EstimatedNormals, OfWallsAreMendedByNeighbours) {
  std::size_t wrong = 0, count = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Shape shape = thin_box(100, 1.5F, seed);
    const std::vector<float> normals = estimate_normals({.positions = shape.positions});
    for (std::size_t i = 0; i < normals.size(); i += 3) {
      if (std::abs(shape.positions[i] - 50) > 45 || std::abs(shape.positions[i + 1] - 50) > 45) continue;
      wrong += std::abs(normals[i + 2]) < 0.866F ? 1 : 0;
      ++count;
    }
  }
  EXPECT_LT(static_cast<double>(wrong), 0.0023 * static_cast<double>(count));
}

// Most of a landscape faces up, also if a roof, whose side is a guess, is its highest place.
TEST(EstimatedNormals, OfALandscapeWithARoofPointUp) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> share;
  for (const float height : {1.2F, 1.6F, 2.0F}) {
    SCOPED_TRACE(height);
    std::vector<float> positions;
    for (int i = 0; i < 6400; ++i) positions.insert(positions.end(), {80 * share(random), 80 * share(random), 0});
    for (int i = 0; i < 400; ++i)
      positions.insert(positions.end(), {30 + 20 * share(random), 30 + 20 * share(random), height});
    const std::vector<float> normals = estimate_normals({.positions = positions});
    std::size_t up = 0;
    for (std::size_t i = 2; i < normals.size(); i += 3) up += normals[i] > 0 ? 1 : 0;
    EXPECT_GT(up, 6200U);
  }
}

// Two scans of one surface that are less than a spacing apart are no wall.
TEST(EstimatedNormals, OfTwoLayersAgree) {
  for (const double apart : {0.25, 0.5, 0.75}) {
    SCOPED_TRACE(std::to_string(apart) + " spacings apart");
    Shape shape = sphere(20000);
    const auto spacing = static_cast<float>(std::sqrt(4 * 3.14159 / 20000));
    for (std::size_t i = 0; i < shape.positions.size(); ++i) {
      if (i / 3 % 2 == 0) shape.positions[i] += static_cast<float>(apart) * spacing * shape.normals[i];
    }
    EXPECT_GT(share_right(estimate_normals({.positions = shape.positions}), shape.normals), 0.9);
  }
}

TEST(EstimatedNormals, PointToTheScanner) {
  const Shape shape = sphere(3000);
  const std::array<float, 3> inside{0.1F, 0, 0};
  const std::vector<float> normals = estimate_normals({.positions = shape.positions}, {.scanner = &inside});
  std::vector<float> inwards = shape.normals;
  for (float& number : inwards) number = -number;
  EXPECT_GT(agreement(normals, inwards), 0.9F);
}

TEST(EstimatedNormals, KeepThoseThatAreGivenAndAgreeWithThem) {
  const Shape shape = sphere(3000);
  std::vector<float> given(shape.normals.size());
  for (std::size_t k = 0; k < 3; ++k) given[k] = -2 * shape.normals[k];  // one normal is given: inwards and too long
  const std::vector<float> normals = estimate_normals({.positions = shape.positions, .normals = given});
  std::vector<float> inwards = shape.normals;
  for (float& number : inwards) number = -number;
  EXPECT_GT(agreement(normals, inwards), 0.9F);
  EXPECT_NEAR(normals[0], inwards[0], 1e-5);
}

TEST(EstimatedNormals, OfTwoPartsAreEachRight) {
  Shape shape = sphere(2000);
  const Shape other = sphere(2000);
  for (std::size_t i = 0; i < other.positions.size(); ++i) {
    shape.positions.push_back(other.positions[i] + (i % 3 == 2 ? -9.0F : 0.0F));
    shape.normals.push_back(other.normals[i]);
  }
  EXPECT_GT(agreement(estimate_normals({.positions = shape.positions}), shape.normals), 0.8F);
}

// Points may be repeated as often as there are neighbours. They must not be all neighbours of a point.
TEST(EstimatedNormals, OfPointsManyTimesAreThoseOfPointsOnce) {
  const Shape shape = sphere(2000);
  const std::vector<float> once = estimate_normals({.positions = shape.positions});
  std::vector<float> positions, normals;
  for (std::size_t i = 0; i < 40; ++i) {
    positions.insert(positions.end(), shape.positions.begin(), shape.positions.end());
    normals.insert(normals.end(), once.begin(), once.end());
  }
  EXPECT_GT(agreement(estimate_normals({.positions = positions}), normals), 0.999F);
}

// The test is fast; comparing all points would take hours.
TEST(EstimatedNormals, OfAMillionPointsAtOnePlaceAreZero) {
  std::vector<float> positions(3000000, 1.0F);
  const std::vector<float> normals = estimate_normals({.positions = positions});
  EXPECT_EQ(std::count(normals.begin(), normals.end(), 0.0F), 3000000);
  positions[0] = 5;
  positions[4] = 7;
  EXPECT_EQ(estimate_normals({.positions = positions}).size(), positions.size());
}

TEST(EstimatedNormals, AreTheSameForAnyNumberOfThreads) {
  const Shape shape = torus(100);
  const PointSet points{.positions = shape.positions};
  EXPECT_EQ(estimate_normals(points, {.threads = 1}), estimate_normals(points, {.threads = 4}));
}

TEST(EstimatedNormals, AreMissingWhereThereIsNoPlane) {
  const std::vector<float> line{0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3};
  for (const float number : estimate_normals({.positions = line})) EXPECT_EQ(number, 0);
}

}  // namespace
}  // namespace glark::vstree::test
