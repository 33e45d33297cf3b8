// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The suite's reference of refinements and its rasterizer, compared with values worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "conformance/reference/raster.h"
#include "conformance/reference/refinement.h"

namespace glark::conformance::reference {
namespace {

// A right triangle in the plane z = 0, with normals along z.
Corners flat() {
  Corners corners;
  corners[0].position = {0, 0, 0, 1};
  corners[1].position = {3, 0, 0, 1};
  corners[2].position = {0, 3, 0, 1};
  for (Corner& corner : corners) corner.normal = {0, 0, 1};
  return corners;
}

void expect_vector(const Vector& actual, const Vector& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-12);
  EXPECT_NEAR(actual.y, expected.y, 1e-12);
  EXPECT_NEAR(actual.z, expected.z, 1e-12);
}

TEST(Refined, RoundsEveryOperation) {
  // (1 + 2^-23) / 4 + 2^-26: rounding to even loses half of the last place. The third product cannot bring it back.
  const float one_more = 1 + std::ldexp(1.0F, -23);
  EXPECT_EQ(refined({0.25F, 0.5F, 0.25F}, one_more, std::ldexp(1.0F, -25), 0),
            0.25F * one_more + std::ldexp(1.0F, -26));
  EXPECT_EQ(refined({0, 1, 0}, 5, 7, 9), 7.0F);
  EXPECT_EQ(refined({0.5F, 0.25F, 0.25F}, 8, 4, -4), 4.0F);
}

TEST(CurvedControlPoint, LiesInTheTangentPlane) {
  Corners corners = flat();
  expect_vector(curved_control_point(corners[0], corners[1]), {1, 0, 0});
  corners[0].normal = {3, 0, 3};  // n = (1, 0, 1) / sqrt 2; D . n n = (1.5, 0, 1.5)
  expect_vector(curved_control_point(corners[0], corners[1]), {0.5, 0, -0.5});
  corners[1].position[3] = 2;
  expect_vector(curved_control_point(corners[0], corners[1]), {1, 0, 0});
}

TEST(CurvedPn, IsTheTriangleWhereItIsFlat) {
  expect_vector(curved_pn(flat(), {0.25F, 0.25F, 0.5F}).position, {0.75, 1.5, 0});
  expect_vector(curved_pn(flat(), {0.25F, 0.25F, 0.5F}).normal, {0, 0, 1});
}

TEST(CurvedPn, MiddleOfAnEdge) {
  Corners corners = flat();
  corners[0].normal = {1, 0, 1};
  // P0 / 8 + P1 / 8 + 3/8 (0.5, 0, -0.5) + 3/8 (2, 0, 0).
  expect_vector(curved_pn(corners, {0.5F, 0.5F, 0}).position, {1.3125, 0, -0.1875});
}

TEST(CurvedPn, CentreOfABulge) {
  Corners corners = flat();
  corners[0].normal = {1, 0, 1};
  // b_01 = (1/2, 0, -1/2), b_02 = (0, 1, 0): the sum of the six is (0.5 + 2 + 2 + 1 + 0 + 0, 0 + 0 + 1 + 2 + 2 + 1, -0.5) =
  // (5.5, 6, -0.5). b = 3/2 B - V/2 = (1.375 - 0.5, 1.5 - 0.5, -0.125). The centre is V/9 + 3/27 sum + 6/27 b.
  const float third = 1.0F / 3;
  const Vector p = curved_pn(corners, {third, third, third}).position;
  EXPECT_NEAR(p.x, 1.0 / 9 + 5.5 / 9 + 2 * 0.875 / 9, 1e-6);
  EXPECT_NEAR(p.y, 1.0 / 9 + 6.0 / 9 + 2 * 1.0 / 9, 1e-6);
  EXPECT_NEAR(p.z, -0.5 / 9 - 2 * 0.125 / 9, 1e-6);
}

TEST(CurvedPn, NormalInTheMiddleIsReflected) {
  Corners corners = flat();
  // N_0 + N_1 = (1, 0, 1), D along x: reflected to (-1, 0, 1). N_0 / 4 + N_1 / 4 + n_01 / 4 has the direction below.
  corners[0].normal = {1, 0, 0};
  const double root = std::sqrt(0.5);
  expect_vector(curved_pn(corners, {0.5F, 0.5F, 0}).normal, direction({1 - root, 0, 1 + root}));
  corners[0].normal = {4, 0, 0};
  expect_vector(curved_pn(corners, {0.5F, 0.5F, 0}).normal, 2.5 * direction({1 - root, 0, 1 + root}));
}

TEST(TaggedControlPoint, TensionDrawsToTheCorner) {
  Corners corners = flat();
  corners[0].tags = {0, 1, 0};
  expect_vector(tagged_control_point(corners[0], corners[1]), {0, 0, 0});
  corners[0].tags = {0, -7, 0};  // -1: (P_i + 2 P_j) / 3
  expect_vector(tagged_control_point(corners[0], corners[1]), {2, 0, 0});
  corners[0].tags = {0, std::numeric_limits<float>::quiet_NaN(), 0};
  expect_vector(tagged_control_point(corners[0], corners[1]), {1, 0, 0});
}

TEST(TaggedControlPoint, SideOfTheCrease) {
  Corners corners = flat();
  // N_0 leans to x; D = (0, 0, 1): d . D = 0 along x, so the edge has no side.
  corners[0].normal = {1, 0, 1};
  corners[0].discontinuity = {0, 0, 1, 1};
  corners[0].tags = {1, 0, 0};
  expect_vector(tagged_control_point(corners[0], corners[1]), {0.5, 0, -0.5});
  // D = (-1, 0, 0): l = (-1) (1/sqrt 2) < 0, the side of N+: the direction of (1/sqrt 2 - 1, 0, 1/sqrt 2).
  corners[0].discontinuity = {-1, 0, 0, 1};
  const Vector n = direction({std::sqrt(0.5) - 1, 0, std::sqrt(0.5)});
  expect_vector(tagged_control_point(corners[0], corners[1]), (Vector{3, 0, 0} - (3 * n.x) * n) / 3);
  // D = (1, 0, 0): the side of N-, whose normal is the same.
  corners[0].discontinuity = {1, 0, 0, 1};
  expect_vector(tagged_control_point(corners[0], corners[1]), (Vector{3, 0, 0} - (3 * n.x) * n) / 3);
}

TEST(TaggedControlPoint, SharpEdgeAndBias) {
  Corners corners = flat();
  corners[0].normal = {1, 0, 1};
  corners[0].discontinuity = {0, 1, 0, 2};
  corners[1].discontinuity = {0, 1, 0, 0};
  corners[0].tags = {1, 0, 1};
  // M = n = (1, 0, 1) / sqrt 2, D . M = 3 / sqrt 2; L the direction of (1/sqrt 2, 1, 1/sqrt 2), half of it squared each.
  const double height = 3 / std::sqrt(2.0);
  const Vector l = {0.5, std::sqrt(0.5), 0.5};
  expect_vector(tagged_control_point(corners[0], corners[1]), (Vector{3, 0, 0} - height * l) / 3);
}

TEST(WeldedControlPoint, OfACubeIsStraightAndOfOneNormalIsCurved) {
  Corners corners = flat();
  corners[0].normal = {0, 1, 0};
  expect_vector(welded_control_point(corners[0], corners[1], {0, 0, 1}), {1, 0, 0});
  corners[0].normal = {1, 0, 1};
  expect_vector(welded_control_point(corners[0], corners[1], {2, 0, 2}), {0.5, 0, -0.5});
  expect_vector(welded_control_point(corners[0], corners[1], {-1, 0, -1}), {0.5, 0, -0.5});
}

TEST(Raster, CentresOnACommonEdgeBelongToOneTriangle) {
  Raster raster(4, 4, 0);
  raster.set_additive(true);
  const RasterVertex corners[4] = {{{-1, -1, 0, 1}, {0.5F, 0, 0, 0}},
                                   {{1, -1, 0, 1}, {0.5F, 0, 0, 0}},
                                   {{1, 1, 0, 1}, {0.5F, 0, 0, 0}},
                                   {{-1, 1, 0, 1}, {0.5F, 0, 0, 0}}};
  raster.triangle(corners[0], corners[1], corners[2]);
  raster.triangle(corners[0], corners[2], corners[3]);
  const Picture picture = raster.picture();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) EXPECT_EQ(picture.at(x, y)[0], 128) << x << " " << y;
}

TEST(Raster, ColoursAreCorrectInPerspective) {
  Raster raster(1, 1, 0);
  // The centre of the window is half way on the screen, but w is 1 at one end and 3 at the other: (0 / 1 + 1 / 3) / (1
  // + 1 / 3).
  raster.triangle({{-1, -1, 0, 1}, {0, 0, 0, 1}}, {{3, -3, 0, 3}, {1, 0, 0, 1}}, {{3, 9, 0, 3}, {1, 0, 0, 1}});
  EXPECT_EQ(raster.picture().at(0, 0)[0], std::lround(255 * 0.25));
}

TEST(Raster, DepthAndUncertainty) {
  Raster raster(2, 2, 0.01);
  raster.set_depth_test(true);
  const auto whole = [&](float depth, float red) {
    raster.triangle({{-3, -1, depth, 1}, {red, 0, 0, 1}}, {{3, -1, depth, 1}, {red, 0, 0, 1}},
                    {{0, 5, depth, 1}, {red, 0, 0, 1}});
  };
  whole(0, 1);
  whole(0.5F, 0);
  EXPECT_EQ(raster.picture().at(1, 1)[0], 255);
  EXPECT_EQ(raster.uncertain_count(), 0);
  raster.triangle({{-0.5F, -1, 0, 1}, {}}, {{-0.5F, 1, 0, 1}, {}}, {{-1, 0, 0, 1}, {}});
  EXPECT_EQ(raster.uncertain_count(), 2);
  EXPECT_THROW(raster.triangle({{0, 0, 0, 0}, {}}, {{1, 0, 0, 1}, {}}, {{0, 1, 0, 1}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace glark::conformance::reference
