// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which points a mesh does not represent.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "glark/clients/reconstruct/result/listed.h"
#include "glark/clients/reconstruct/result/loss.h"
#include "tests/reconstruct/meshes.h"
#include "tests/reconstruct/thin_shapes.h"

namespace glark::reconstruct::test {
namespace {

Loss loss_with(const PointSet& points, const Reconstructed& mesh, std::span<const std::uint32_t> outliers = {},
               float tolerance = 0) {
  return loss_of(points, outliers, {mesh.positions, mesh.normals, mesh.triangles}, tolerance, common::Workers(2));
}

// A square in the plane z = 0, of two triangles.
Reconstructed square(float side) {
  Reconstructed mesh;
  mesh.positions = {0, 0, 0, side, 0, 0, side, side, 0, 0, side, 0};
  mesh.triangles = {0, 1, 2, 0, 2, 3};
  return mesh;
}

// A grid of points with normals along z, one unit apart.
Shape grid(int side, float height) {
  Shape shape;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      shape.positions.insert(shape.positions.end(), {static_cast<float>(column), static_cast<float>(row), height});
      shape.normals.insert(shape.normals.end(), {0, 0, 1});
    }
  }
  return shape;
}

void add(Shape& shape, const Shape& other) {
  shape.positions.insert(shape.positions.end(), other.positions.begin(), other.positions.end());
  shape.normals.insert(shape.normals.end(), other.normals.begin(), other.normals.end());
}

// The sixth neighbour in the middle of a grid is at the root of 2, so the bound is about 3. At a corner, it is about 5.
TEST(Loss, PointsFartherThanThreeSpacingsAreLost) {
  for (const float height : {0.0F, 2.5F, 6.0F}) {
    const Loss loss = loss_with(grid(40, height).points(), square(39));
    EXPECT_EQ(1600U, loss.points);
    EXPECT_EQ(1600U, loss.measured);
    EXPECT_EQ(height > 4 ? 1600U : 0U, loss.lost) << height;
  }
}

TEST(Loss, AMeshWithoutTrianglesLosesAll) { EXPECT_EQ(1.0, loss_with(grid(10, 0).points(), {}).share()); }

// The other side of a thin sheet does not represent a point, although it is near.
TEST(Loss, TrianglesThatFaceAwayDoNotCount) {
  Shape shape = grid(40, 0);
  for (float& number : shape.normals) number = -number;
  Reconstructed mesh = square(39);
  EXPECT_EQ(1600U, loss_with(shape.points(), mesh).lost);
  mesh.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  EXPECT_EQ(1600U, loss_with(shape.points(), mesh).lost);
}

TEST(Loss, OutliersDoNotCount) {
  Shape shape = grid(40, 0);
  add(shape, grid(10, 9));
  std::vector<std::uint32_t> outliers(100);
  EXPECT_EQ(100U, loss_with(shape.points(), square(39)).lost);
  std::iota(outliers.begin(), outliers.end(), 1600U);
  const Loss loss = loss_with(shape.points(), square(39), outliers);
  EXPECT_EQ(0U, loss.lost);
  EXPECT_EQ(1600U, loss.points);
}

TEST(Loss, TheToleranceIsAdded) {
  EXPECT_EQ(0U, loss_with(grid(40, 9).points(), square(39), {}, 7).lost);
  EXPECT_EQ(1600U, loss_with(grid(40, 9).points(), square(39), {}, 4).lost);
}

// The bound must not grow with the height of the stack: five sheets, of which the mesh has the lowest.
TEST(Loss, AStackOfSheetsIsNoNoise) {
  Shape shape = grid(60, 0);
  for (int sheet = 1; sheet < 5; ++sheet) add(shape, grid(60, 5.0F * static_cast<float>(sheet)));
  const Loss loss = loss_with(shape.points(), square(59));
  EXPECT_NEAR(0.8, loss.share(), 0.01);
}

// Dense points far from the mesh are lost, although the mesh is near by the spacing of the sparse ones.
TEST(Loss, TheSpacingIsThatOfThePointsAround) {
  Shape shape = grid(40, 0);
  Shape dense = grid(40, 0);
  for (std::size_t i = 0; i < dense.positions.size(); ++i)
    dense.positions[i] = i % 3 == 2 ? 2.0F : 10 + 0.05F * dense.positions[i];
  add(shape, dense);
  EXPECT_EQ(1600U, loss_with(shape.points(), square(39)).lost);
}

TEST(Loss, OfManyPointsSomeAreMeasured) {
  const Loss loss = loss_with(grid(400, 0).points(), square(200));
  EXPECT_EQ(160000U, loss.points);
  EXPECT_EQ(most_measured, loss.measured);
  EXPECT_NEAR(1 - 203.0 * 203.0 / 160000, loss.share(), 0.02);
}

TEST(Loss, SmallAndLargeTrianglesReachTheSamePoints) {
  const Shape shape = grid(40, 2);
  Reconstructed fine;
  for (int row = 0; row < 390; ++row) {
    for (int column = 0; column < 390; ++column) {
      const auto first = static_cast<std::uint32_t>(fine.positions.size() / 3);
      const float x = 0.1F * static_cast<float>(column), y = 0.1F * static_cast<float>(row);
      fine.positions.insert(fine.positions.end(), {x, y, 0, x + 0.1F, y, 0, x + 0.1F, y + 0.1F, 0, x, y + 0.1F, 0});
      for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) fine.triangles.push_back(first + corner);
    }
  }
  EXPECT_EQ(loss_with(shape.points(), square(39)).lost, loss_with(shape.points(), fine).lost);
}

// Clean data never reach the bound: thin sheets, and smooth shapes with noise.
TEST(Loss, GoodMeshesLoseNothing) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    const Rotation rotation = random_rotation(seed);
    std::vector<Shape> shapes;
    for (const double apart : {0.5, 1.0, 2.0, 6.0})
      shapes.push_back(samples_of(plates(50, apart), rotation, seed, 0.3));
    for (const double thickness : {2.0, 4.0})
      shapes.push_back(samples_of(ellipsoid(70, 50, thickness), rotation, seed, 0.3));
    shapes.push_back(samples_of(wing(30, 90, 3), rotation, seed, 0.3));
    for (const Shape& shape : shapes) {
      const Listed result = reconstruct_and_list(shape.points(), {});
      EXPECT_LT(loss_with(shape.points(), result.mesh, result.outliers).share(), 0.005) << seed;
    }
  }
}

TEST(Loss, NoiseIsNoLoss) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    for (const double noise : {0.3, 1.0, 3.0}) {
      Shape shape = samples_of(plates(90, 60), random_rotation(seed), seed, 0.5);
      std::mt19937 random(seed);
      std::normal_distribution<float> number(0, static_cast<float>(noise));
      for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        const float along = number(random);
        for (std::size_t k = 0; k < 3; ++k) shape.positions[i + k] += along * shape.normals[i + k];
      }
      const Listed result = reconstruct_and_list(shape.points(), {});
      EXPECT_LT(loss_with(shape.points(), result.mesh, result.outliers).share(), 0.005) << noise << ", " << seed;
    }
  }
}

// Outliers are listed by the indices of the given samples.
TEST(Loss, OutliersAreListed) {
  Shape shape = grid(60, 0);
  Shape all = grid(0, 0);
  for (int i = 0; i < 60; ++i) {  // outliers come first
    all.positions.insert(all.positions.end(), {static_cast<float>(i), static_cast<float>(7 * i % 60),
                                               20.0F + 3 * static_cast<float>(i % 7)});
    all.normals.insert(all.normals.end(), {1, 0, 0});
  }
  add(all, shape);
  const Listed result = reconstruct_and_list(all.points(), {});
  EXPECT_EQ(result.mesh.outliers, result.outliers.size());
  ASSERT_GT(result.outliers.size(), 40U);
  EXPECT_TRUE(std::ranges::is_sorted(result.outliers));
  EXPECT_LT(result.outliers.back(), 60U);
}

}  // namespace
}  // namespace glark::reconstruct::test
