// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clouds that are too noisy for a surface: their points are drawn as points, and building stays cheap.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shapes/clouds.h"
#include "tests/surfel/clouds.h"
#include "tests/surfel/cull/views.h"

namespace glark::surfel::test {
namespace {

Cloud view_of(const shapes::Cloud& cloud) { return {cloud.positions, cloud.normals}; }

TEST(NoisyClouds, FogStaysPoints) {
  for (const unsigned seed : {1U, 2U}) {
    const shapes::Cloud cloud = shapes::fog(seed, 20000);
    const Strips strips(view_of(cloud));
    const Counts counts = strips.counts(0);
    EXPECT_GT(counts.loose_points, 16000U);
    EXPECT_LT(counts.indices, 15000U);
  }
}

TEST(NoisyClouds, AStatueInThickNoiseStaysPoints) {
  const shapes::Statue statue(3);
  const shapes::Cloud cloud = cloud_of(statue, 3, {.samples = 50000, .noise = 0.05});
  EXPECT_GT(Strips(view_of(cloud)).counts(0).loose_points, 25000U);
}

TEST(NoisyClouds, ACleanStatueHasNoLoosePoints) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const shapes::Statue statue(seed);
    const shapes::Cloud cloud = cloud_of(statue, seed, {.samples = 20000});
    EXPECT_EQ(Strips(view_of(cloud)).counts(0).loose_points, 0U);
  }
}

// Each point is drawn once, as a point, as long as its node is larger than a pixel.
TEST(NoisyClouds, LoosePointsAreDrawnAsPoints) {
  const shapes::Cloud cloud = shapes::fog(4, 4000);
  const Strips strips(view_of(cloud));
  Frame frame;
  strips.select({.clip_from_object = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2},
                 .width = 4096,
                 .height = 4096,
                 .cull_frustum = false},
                frame);
  EXPECT_EQ(frame.points.size(), strips.counts(0).loose_points);
  std::sort(frame.points.begin(), frame.points.end());
  EXPECT_EQ(std::adjacent_find(frame.points.begin(), frame.points.end()), frame.points.end());
}

// A part of the fog moves onto a sphere: it gets triangles.
TEST(NoisyClouds, PointsThatMoveToASurfaceAreStripped) {
  shapes::Cloud cloud = shapes::fog(5, 8000);
  Strips strips(view_of(cloud));
  const std::size_t before = strips.counts(0).loose_points;
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    const float height = 1 - static_cast<float>(i) / 2000, angle = 2.39996F * static_cast<float>(i);
    const float radius = std::sqrt(std::max(0.0F, 1 - height * height));
    const float point[3] = {radius * std::cos(angle), radius * std::sin(angle), height};
    for (std::size_t k = 0; k < 3; ++k) {
      cloud.normals[3 * i + k] = point[k];
      cloud.positions[3 * i + k] = point[k] + (k == 0 ? 5.0F : 0.0F);
    }
    moved.push_back(i);
  }
  strips.update(view_of(cloud), moved);
  const Counts counts = strips.counts(0);
  EXPECT_LT(counts.loose_points, before - 3500);
  EXPECT_GT(counts.valid, 7000U);
}

}  // namespace
}  // namespace glark::surfel::test
