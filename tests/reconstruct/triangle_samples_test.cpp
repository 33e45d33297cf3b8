// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points on large triangles.
#include <gtest/gtest.h>

#include <cmath>

#include "glark/clients/reconstruct/samples/triangle_samples.h"

namespace glark::reconstruct::test {
namespace {

// A sheet of 20 x 20 squares, and a triangle beside it with a multiple of their area.
struct Sheet {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;

  explicit Sheet(float large) {
    for (int row = 0; row < 21; ++row) {
      for (int column = 0; column < 21; ++column)
        positions.insert(positions.end(), {static_cast<float>(column), static_cast<float>(row), 0});
    }
    for (std::uint32_t i = 0; i < 420; ++i) {
      if (i % 21 < 20) triangles.insert(triangles.end(), {i, i + 1, i + 22, i, i + 22, i + 21});
    }
    if (large == 0) return;
    positions.insert(positions.end(), {30, 0, 5, 30, large, 5, 30, 0, 5 + large});
    triangles.insert(triangles.end(), {441, 442, 443});
  }
};

TEST(TriangleSamples, FindLongTriangles) {
  const Sheet even(0), uneven(20);
  EXPECT_EQ(0, share_of_long_triangles(even.positions, even.triangles));
  EXPECT_NEAR(1.0 / 3, share_of_long_triangles(uneven.positions, uneven.triangles), 1e-6);
  EXPECT_EQ(0, share_of_long_triangles({}, {}));
}

TEST(TriangleSamples, EachAreaHasItsShare) {
  const Sheet sheet(20);
  for (const std::size_t count : {600, 6000}) {
    const TriangleSamples samples = sample_triangles(sheet.positions, {}, sheet.triangles, count);
    EXPECT_NEAR(3 * static_cast<double>(count), static_cast<double>(samples.positions.size()), 3);
    std::size_t beside = 0;
    for (std::size_t i = 0; i < samples.positions.size(); i += 3) {
      const bool is_beside = samples.positions[i] > 25;
      beside += is_beside ? 1 : 0;
      EXPECT_FLOAT_EQ(is_beside ? 1 : 0, samples.normals[i]);
      EXPECT_FLOAT_EQ(is_beside ? 0 : 1, samples.normals[i + 2]);
    }
    EXPECT_NEAR(static_cast<double>(count) / 3, static_cast<double>(beside), 1);
    EXPECT_EQ(samples.positions, sample_triangles(sheet.positions, {}, sheet.triangles, count).positions);
  }
}

// No square of a twentieth of the side is empty, although it has only ten samples on average.
TEST(TriangleSamples, FillATriangleEvenly) {
  const std::vector<float> positions{0, 0, 0, 20, 0, 0, 0, 20, 0};
  const TriangleSamples samples = sample_triangles(positions, {}, std::vector<std::uint32_t>{0, 1, 2}, 2000);
  std::vector<int> counts(400);
  for (std::size_t i = 0; i < samples.positions.size(); i += 3)
    ++counts[static_cast<std::size_t>(samples.positions[i]) + 20 * static_cast<std::size_t>(samples.positions[i + 1])];
  for (std::size_t row = 0; row < 19; ++row) {
    for (std::size_t column = 0; row + column < 19; ++column)
      EXPECT_GE(counts[column + 20 * row], 3) << column << ", " << row;
  }
}

TEST(TriangleSamples, MixTheColoursOfTheCorners) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<std::uint8_t> colours{200, 0, 0, 255, 0, 200, 0, 255, 0, 0, 200, 255};
  const TriangleSamples samples = sample_triangles(positions, colours, std::vector<std::uint32_t>{0, 1, 2}, 100);
  ASSERT_EQ(samples.positions.size() / 3, samples.colours.size() / 4);
  for (std::size_t i = 0; i < samples.colours.size() / 4; ++i) {
    EXPECT_NEAR(200 * samples.positions[3 * i], samples.colours[4 * i + 1], 1);
    EXPECT_NEAR(200 * samples.positions[3 * i + 1], samples.colours[4 * i + 2], 1);
    EXPECT_EQ(255, samples.colours[4 * i + 3]);
  }
}

TEST(TriangleSamples, TrianglesWithoutAreaHaveNone) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 2, 0, 0};
  EXPECT_TRUE(sample_triangles(positions, {}, std::vector<std::uint32_t>{0, 1, 2}, 100).positions.empty());
}

}  // namespace
}  // namespace glark::reconstruct::test
