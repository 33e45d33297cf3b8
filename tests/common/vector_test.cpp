// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/common/vector.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "glark/clients/common/vertex_normals.h"

namespace glark::common::test {
namespace {

TEST(Vector3, CrossIsPerpendicularAndRightHanded) {
  EXPECT_EQ(cross(Vector3d{1, 0, 0}, Vector3d{0, 1, 0}), (Vector3d{0, 0, 1}));
  const Vector3d a{1, 2, 3}, b{-2, 0.5, 4};
  EXPECT_EQ(dot(cross(a, b), a), 0);
  EXPECT_EQ(dot(cross(a, b), b), 0);
}

TEST(Vector3, IndexesItsCoordinates) {
  Vector3f v{1, 2, 3};
  v[1] = 5;
  EXPECT_EQ(to_array(v), (std::array<float, 3>{1, 5, 3}));
  EXPECT_EQ(v[2], 3);
}

TEST(Vector3, UnitVectorsOfAnyLengthHaveLengthOne) {
  for (const float size : {1e-38F, 1e-20F, 1.0F, 1e20F, 1e38F}) {
    const Vector3f v = unit(Vector3f{0, 0.6F * size, -0.8F * size});
    EXPECT_NEAR(v.y, 0.6F, 1e-6F) << size;
    EXPECT_NEAR(v.z, -0.8F, 1e-6F) << size;
  }
}

TEST(Vector3, UnitOfWhatHasNoDirectionIsZero) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(is_zero(unit(Vector3f{})));
  EXPECT_TRUE(is_zero(unit(Vector3f{infinity, 0, 0})));
  EXPECT_TRUE(is_zero(unit(Vector3f{std::numeric_limits<float>::quiet_NaN(), 1, 0})));
}

TEST(VertexNormals, AreWeightedByArea) {
  // A triangle of area 2 in the plane z = 0, and one of area 1 in the plane x = 0.
  const std::vector<float> positions = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 1};
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 2, 3};
  std::vector<Vector3f> normals(4);
  add_triangle_normals(
      triangles, [&](std::uint32_t vertex) { return vector_at(std::span<const float>(positions), vertex); },
      [&](std::uint32_t vertex, Vector3f normal) { normals[vertex] += normal; });
  EXPECT_EQ(normals[0], (Vector3f{2, 0, 4}));
  EXPECT_EQ(normals[1], (Vector3f{0, 0, 4}));
  EXPECT_EQ(normals[3], (Vector3f{2, 0, 0}));
}

}  // namespace
}  // namespace glark::common::test
