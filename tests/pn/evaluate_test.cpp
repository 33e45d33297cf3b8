// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tests the effect of the tags (Boubekeur 2007, ch. 8.2.2) on a ridge along the x axis. The sides of the ridge fall
// towards y > 0 and towards y < 0.
#include <gtest/gtest.h>

#include <cmath>

#include "glark/pn.h"

namespace glark::pn::test {
namespace {

using Triangle = std::array<Corner, 3>;

// The triangle has two ends of the ridge, whose normals lean outwards so that it bulges, and a smooth corner on one
// side. N+ is the normal of the side y > 0.
Triangle side(float y, const std::array<float, 3>& tags) {
  const float h = std::sqrt(0.5F);
  const Corner left{{-1, 0, 0}, {-0.5F, 0, 1}, {0, 1, 0, 2}, tags};
  const Corner right{{1, 0, 0}, {0.5F, 0, 1}, {0, 1, 0, 2}, tags};
  const Corner far{{0, y, -1}, {0, y * h, h}};
  return y > 0 ? Triangle{left, right, far} : Triangle{right, left, far};
}

double angle_across(const std::array<float, 3>& tags) {
  const Sample plus = evaluate(side(1, tags), {0.5, 0.5, 0});
  const Sample minus = evaluate(side(-1, tags), {0.5, 0.5, 0});
  double product = 0;
  double a = 0;
  double b = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(plus.position[i], minus.position[i]) << "the ridge is one";
    product += plus.normal[i] * minus.normal[i];
    a += plus.normal[i] * plus.normal[i];
    b += minus.normal[i] * minus.normal[i];
  }
  return std::acos(std::min(1.0, product / std::sqrt(a * b))) * 180 / M_PI;
}

double crest(const std::array<float, 3>& tags, std::size_t axis) {
  return evaluate(side(1, tags), {0.5, 0.5, 0}).position[axis];
}

TEST(Evaluate, SharpnessPartsTheNormals) {
  EXPECT_NEAR(angle_across({0, 0, 0}), 0, 1e-5);
  double before = 0;
  for (const float sharpness : {0.25F, 0.5F, 1.0F, 2.0F}) {
    EXPECT_GT(angle_across({sharpness, 0, 0}), before + 5);
    before = angle_across({sharpness, 0, 0});
  }
  EXPECT_NEAR(angle_across({65536, 0, 0}), 180, 0.1) << "along the discontinuity itself";
}

TEST(Evaluate, SharpnessTurnsEachSideToItsOwn) {
  EXPECT_GT(evaluate(side(1, {1, 0, 0}), {0.5, 0.5, 0}).normal[1], 0.5);
  EXPECT_LT(evaluate(side(-1, {1, 0, 0}), {0.5, 0.5, 0}).normal[1], -0.5);
}

TEST(Evaluate, TensionFlattensTheRidge) {
  double before = 1;
  for (const float tension : {-1.0F, 0.0F, 0.5F, 1.0F}) {
    EXPECT_LT(crest({0, tension, 0}, 2), before);
    before = crest({0, tension, 0}, 2);
  }
  EXPECT_NEAR(before, 0, 1e-12) << "straight";
  EXPECT_NEAR(crest({0, -1, 0}, 2), 2 * crest({0, 0, 0}, 2), 1e-12);
}

TEST(Evaluate, BiasLeansTheRidge) {
  EXPECT_NEAR(crest({0, 0, 0}, 1), 0, 1e-12);
  EXPECT_GT(crest({0, 0, 0.5F}, 1), 0.02) << "towards N+";
  EXPECT_NEAR(crest({0, 0, -0.5F}, 1), -crest({0, 0, 0.5F}, 1), 1e-12);
  EXPECT_EQ(crest({1, 0, 0.5F}, 1), crest({0, 0, 0.5F}, 1)) << "sharpness has no say in the ridge";
}

TEST(Evaluate, CreasesOfDifferentNumbersAreNotOne) {
  Triangle triangle = side(1, {0, 0, 1});
  triangle[1].discontinuity[3] = 3;
  EXPECT_NEAR(evaluate(triangle, {0.5, 0.5, 0}).position[1], 0, 1e-12) << "no bias where nothing is sharp";
  triangle[1].discontinuity[3] = 0;
  EXPECT_GT(evaluate(triangle, {0.5, 0.5, 0}).position[1], 0.02) << "0 is of all creases";
}

}  // namespace
}  // namespace glark::pn::test
