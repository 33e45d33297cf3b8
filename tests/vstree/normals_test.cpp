// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

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

TEST(EstimatedNormals, PointOutOfClosedSurfaces) {
  for (const Shape& shape : {torus(150, 0), sphere(5000), sphere(5000, 0.005F)}) {
    EXPECT_GT(agreement(estimate_normals({.positions = shape.positions}), shape.normals), 0.8F);
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
