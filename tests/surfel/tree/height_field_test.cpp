// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/tree/height_field.h"

#include <gtest/gtest.h>

#include <vector>

namespace glark::surfel::test {
namespace {

constexpr HeightFieldLimits limits = {0, 0.5F};

Shape shape_of(const std::vector<Surfel>& surfels) { return classify_shape(surfels, fit_plane(surfels), limits); }

TEST(SurfelHeightField, FlatSurfelsAreAHeightField) {
  EXPECT_EQ(shape_of({{{0, 0, 0}, 0, {0, 0, 1}}, {{1, 0, 0}, 1, {0, 0, 1}}, {{0, 1, 0}, 2, {0, 0, 1}}}),
            Shape::height_field);
}

TEST(SurfelHeightField, OpposedNormalsAreFolded) {
  EXPECT_EQ(shape_of({{{0, 0, 0}, 0, {0, 0, 1}}, {{1, 0, 0}, 1, {0, 0, 1}}, {{0, 1, 0}, 2, {0, 0, -1}}}),
            Shape::folded);
}

TEST(SurfelHeightField, FarSurfelsAreThick) {
  EXPECT_EQ(shape_of({{{0, 0, 0}, 0, {0, 0, 1}}, {{1, 0, 0}, 1, {0, 0, 1}}, {{0, 0, 5}, 2, {0, 0, 1}}}), Shape::thick);
}

TEST(SurfelHeightField, FoldsAreSplitByNormals) {
  std::vector<Surfel> surfels = {{{0, 0, 0}, 0, {0, 0, 1}},
                                 {{1, 0, 0}, 1, {0, 0, -1}},
                                 {{2, 0, 0}, 2, {0, 0, 1}},
                                 {{3, 0, 0}, 3, {0, 0.6F, -0.8F}},
                                 {{4, 0, 0}, 4, {0, 0, 1}}};
  const std::size_t first = split_by_normals(surfels, fit_plane(surfels));
  ASSERT_TRUE(first == 2 || first == 3);
  for (std::size_t i = 1; i < first; ++i) EXPECT_GT(surfels[i].normal.z * surfels[0].normal.z, 0);
  for (std::size_t i = first; i < surfels.size(); ++i) EXPECT_LT(surfels[i].normal.z * surfels[0].normal.z, 0);
}

}  // namespace
}  // namespace glark::surfel::test
