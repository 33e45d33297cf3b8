// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "glark/clients/surfel/selection.h"
#include "tests/surfel/clouds.h"

namespace glark::surfel::test {
namespace {

using Matrix = std::array<float, 16>;

// Looks along -z from (x, y, z).
Matrix perspective(float x, float y, float z, float slope = 0.5F) {
  const float near = 0.01F, far = 100;
  const float a = -(far + near) / (far - near), b = -2 * far * near / (far - near);
  return {1 / slope, 0, 0, 0, 0, 1 / slope, 0, 0, 0, 0, a, -1, -x / slope, -y / slope, -z * a + b, z};
}

Matrix parallel(float half_width) {
  return {1 / half_width, 0, 0, 0, 0, 1 / half_width, 0, 0, 0, 0, -0.01F, 0, 0, 0, 0, 1};
}

std::array<float, 4> clip(const Matrix& m, const float* p) {
  std::array<float, 4> at{};
  for (std::size_t r = 0; r < 4; ++r) at[r] = m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r];
  return at;
}

// Whether a triangle could be seen: not wholly beyond a plane, and counter-clockwise on the screen.
bool can_be_seen(const Points& points, const Matrix& matrix, const Triangle& triangle) {
  std::array<std::array<float, 4>, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = clip(matrix, &points.positions[3 * triangle[k]]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::all_of(p.begin(), p.end(), [&](const auto& c) { return c[axis] > c[3]; })) return false;
    if (std::all_of(p.begin(), p.end(), [&](const auto& c) { return c[axis] < -c[3]; })) return false;
  }
  const double determinant = double{p[0][0]} * (double{p[1][1]} * p[2][3] - double{p[1][3]} * p[2][1]) -
                             double{p[0][1]} * (double{p[1][0]} * p[2][3] - double{p[1][3]} * p[2][0]) +
                             double{p[0][3]} * (double{p[1][0]} * p[2][1] - double{p[1][1]} * p[2][0]);
  return determinant > 0;
}

// No triangle that could be seen is left out.
void expect_complete(const Points& points, const Strips& strips, const Matrix& matrix) {
  Frame frame;
  strips.select({.clip_from_object = matrix, .width = 100, .height = 100, .point_pixels = 0}, frame);
  std::set<std::size_t> drawn;
  for (const void* offset : frame.offsets) drawn.insert(reinterpret_cast<std::uintptr_t>(offset) / 4);
  std::size_t leaf = 0;
  const auto all = patches(strips);
  for (const Node& node : strips.nodes()) {
    if (node.left != none || node.count == 0) continue;
    for (const Triangle& triangle : all[leaf]) {
      ASSERT_TRUE(drawn.contains(node.first) || !can_be_seen(points, matrix, triangle)) << "patch " << leaf;
    }
    ++leaf;
  }
}

TEST(Selection, LeavesNothingOutThatIsSeen) {
  const Points points = torus(20000);
  const Strips strips(points.cloud());
  for (const float z : {0.2F, 1.0F, 3.0F, 20.0F}) {
    expect_complete(points, strips, perspective(0.3F, 0, z));
    expect_complete(points, strips, perspective(1, 0.2F, z, 2));
  }
  expect_complete(points, strips, parallel(0.5F));
  expect_complete(points, strips, parallel(3));
}

// The squares of its lengths are no floats.
TEST(Selection, LeavesNothingOutOfWhatIsTiny) {
  constexpr float size = 1e-30F;
  Points points = torus(5000);
  for (float& coordinate : points.positions) coordinate *= size;
  const Strips strips(points.cloud(), {.leaf_points = 32});
  for (const float z : {0.2F, 1.0F, 3.0F, 20.0F}) {
    Matrix matrix = perspective(0.3F, 0, z);
    for (std::size_t i = 0; i < 12; ++i) matrix[i] /= size;
    expect_complete(points, strips, matrix);
  }
}

// Of what is drawn, edges that have turned in strips among it.
TEST(Selection, ConesHoldTheNormalsAndTheirApexLiesBehindTheTriangles) {
  const Points points = torus(20000);
  const Strips strips(points.cloud());
  ASSERT_GT(strips.counts().turned, 500U);
  std::size_t leaf = 0, closed = 0;
  const auto all = patches(strips);
  for (const Node& node : strips.nodes()) {
    if (node.left != none || node.count == 0) continue;
    const auto& patch = all[leaf++];
    if (node.cone_sine >= 1) continue;
    ++closed;
    const double least_cosine = std::sqrt(1 - double{node.cone_sine} * node.cone_sine);
    for (const auto& [a, b, c] : patch) {
      const auto at = [&](std::uint32_t point, std::size_t k) { return double{points.positions[3UL * point + k]}; };
      std::array<double, 3> u{}, v{};
      for (std::size_t k = 0; k < 3; ++k) {
        u[k] = at(b, k) - at(a, k);
        v[k] = at(c, k) - at(a, k);
      }
      double size = 0, along = 0, above = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double normal = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
        size += normal * normal;
        along += normal * node.cone_axis[k];
        above += normal * (at(a, k) - node.cone_apex[k]);
      }
      EXPECT_GE(along / std::sqrt(size), least_cosine);
      EXPECT_GE(above / std::sqrt(size), 0);
    }
  }
  EXPECT_GT(closed, leaf / 2);
}

TEST(Selection, LeavesOutHalfOfASphere) {
  const Strips strips(sphere(50000).cloud());
  Frame frame;
  View view{.clip_from_object = parallel(2), .width = 2000, .height = 2000};
  strips.select(view, frame);
  EXPECT_GT(frame.back_faces, 0U);
  EXPECT_LT(frame.indices, strips.indices().size() * 60 / 100);
  EXPECT_GT(frame.indices, strips.indices().size() * 45 / 100);
  view.cull_back_faces = false;
  strips.select(view, frame);
  EXPECT_EQ(frame.indices, strips.indices().size());
}

// At the edge of a wide view spheres are longer than in its middle.
TEST(Selection, DiametersAreThoseOfSpheresOnTheScreenOrALittleMore) {
  const View view{.clip_from_object = perspective(0, 0, 0, 2), .width = 400, .height = 400};
  const Camera camera(view);
  constexpr float radius = 0.01F;
  for (const float x : {0.0F, 1.0F, -1.9F}) {
    std::array<float, 2> low{1e9F, 1e9F}, high{-1e9F, -1e9F};
    const Points on_sphere = sphere(5000);
    for (std::size_t i = 0; i < on_sphere.size(); ++i) {
      const float* const d = &on_sphere.positions[3 * i];
      const std::array<float, 3> at = {x + radius * d[0], 0.5F + radius * d[1], -1 + radius * d[2]};
      const auto place = clip(view.clip_from_object, at.data());
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], 200 * place[k] / place[3]);
        high[k] = std::max(high[k], 200 * place[k] / place[3]);
      }
    }
    const float size = std::max(high[0] - low[0], high[1] - low[1]);
    const float said = camera.diameter({x, 0.5F, -1}, radius);
    EXPECT_GE(said, size * 0.999F);
    EXPECT_LE(said, size * 1.05F);
  }
  EXPECT_TRUE(std::isinf(camera.diameter({0, 0, -0.5F * radius}, radius)));
}

TEST(Selection, LeavesOutWhatIsBesideTheView) {
  const Strips strips(sphere(50000).cloud(), {.leaf_points = 40});
  Frame frame;
  View view{.clip_from_object = perspective(0, 0, 1.2F, 0.2F), .width = 500, .height = 500};
  strips.select(view, frame);
  EXPECT_GT(frame.out_of_frustum, 0U);
  EXPECT_LT(frame.indices, strips.indices().size() / 20);
  EXPECT_LT(frame.visited, strips.nodes().size() / 10) << "whole subtrees are left out";
  view.cull_frustum = false;
  view.cull_back_faces = false;
  strips.select(view, frame);
  EXPECT_EQ(frame.indices, strips.indices().size());
}

TEST(Selection, WhatIsFarIsPoints) {
  const Points points = sphere(50000);
  const Strips strips(points.cloud());
  Frame frame;
  strips.select({.clip_from_object = perspective(0, 0, 90), .width = 100, .height = 100}, frame);
  EXPECT_EQ(frame.strips, 0U);
  EXPECT_GT(frame.points.size(), 0U);
  EXPECT_LT(frame.points.size(), 100U);
  for (const std::uint32_t point : frame.points) EXPECT_LT(point, points.size());
  strips.select({.clip_from_object = perspective(0, 0, 3), .width = 1000, .height = 1000}, frame);
  EXPECT_TRUE(frame.points.empty());
}

TEST(Selection, WhatIsFarIsOfACoarserLevel) {
  const Strips strips(sphere(50000).cloud(), {.levels = 4});
  Frame frame;
  unsigned before = 0;
  for (const float z : {1.5F, 6.0F, 30.0F, 95.0F}) {
    strips.select({.clip_from_object = perspective(0, 0, z), .width = 500, .height = 500, .point_pixels = 0}, frame);
    EXPECT_GE(frame.level, before);
    before = frame.level;
    EXPECT_GT(frame.strips, 0U);
  }
  EXPECT_EQ(before, 3U);
  strips.select(
      {.clip_from_object = perspective(0, 0, 95), .width = 500, .height = 500, .point_pixels = 0, .level_pixels = 0},
      frame);
  EXPECT_EQ(frame.level, 0U);
}

}  // namespace
}  // namespace glark::surfel::test
