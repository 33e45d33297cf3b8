// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compares the limit surface with the limit points of the repeatedly refined mesh, which are computed in another way.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

double distance(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class LoopSurfaceOf : public testing::TestWithParam<ControlMesh> {};

// The limit points of the mesh after one step lie at quarters of the parameter: at vertices and edge midpoints.
TEST_P(LoopSurfaceOf, MeetsTheLimitStepAtQuarters) {
  const ControlMesh& mesh = GetParam();
  LoopSurface exact(mesh.view());
  Surface steps(mesh.view(), {.splits = 1});
  exact.update(mesh.positions);
  steps.update(mesh.positions);
  constexpr std::array<std::array<float, 3>, 3> ends = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double farthest = 0, farthest_normal = 0;
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t) {
    for (std::size_t child = 0; child < 3; ++child) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<float, 3> at{};
        for (std::size_t k = 0; k < 3; ++k) at[k] = ends[child][k] * 0.75F + ends[i][k] * 0.25F;
        const std::array<float, 3> half = {(ends[child][0] + ends[i][0]) / 2, (ends[child][1] + ends[i][1]) / 2,
                                           (ends[child][2] + ends[i][2]) / 2};
        const Sample sample = exact.evaluate(t, at), other = steps.evaluate(4 * t + child, half);
        farthest = std::max(farthest, distance(sample.position, other.position) / mesh.diagonal());
        farthest_normal = std::max(farthest_normal, distance(sample.normal, other.normal));
      }
    }
  }
  EXPECT_LE(farthest, 1e-6);
  EXPECT_LE(farthest_normal, 2e-6);
}

TEST_P(LoopSurfaceOf, RefinesToTheSamePoints) {
  const ControlMesh& mesh = GetParam();
  LoopSurface exact(mesh.view());
  exact.update(mesh.positions);
  constexpr unsigned level = 3, side = 8;
  constexpr std::size_t each = (side + 1) * (side + 2) / 2;
  std::vector<Sample> samples(mesh.triangles.size() / 3 * each);
  exact.refine(level, samples);
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; t += 3) {
    std::size_t index = t * each;
    for (unsigned i = 0; i <= side; ++i) {
      for (unsigned j = 0; i + j <= side; ++j, ++index) {
        const Sample sample = exact.evaluate(t, {float(side - i - j) / side, float(i) / side, float(j) / side});
        ASSERT_LE(distance(sample.position, samples[index].position), 1e-6 * mesh.diagonal())
            << t << " " << i << " " << j;
        ASSERT_LE(distance(sample.normal, samples[index].normal), 2e-6) << t << " " << i << " " << j;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, LoopSurfaceOf, testing::ValuesIn(small_meshes()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(LoopSurface, IsContinuousAcrossEdgesAndTowardsVertices) {
  const ControlMesh mesh = bipyramid(9);
  LoopSurface exact(mesh.view());
  exact.update(mesh.positions);
  for (const float near : {1e-2F, 1e-4F, 1e-6F}) {
    const Sample corner = exact.evaluate(0, {0, 0, 1}), beside = exact.evaluate(0, {near / 2, near / 2, 1 - near});
    EXPECT_LE(distance(corner.position, beside.position), 3 * std::pow(near, 0.6));
    EXPECT_LE(distance(corner.normal, beside.normal), 3 * std::pow(near, 0.6));
  }
}

TEST(LoopSurface, TakesWhatSurfaceTakes) {
  const ControlMesh mesh{
      "odd", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1, 5, 5, 5}, {0, 1, 2, 2, 1, 3, 1, 0, 2, 3, 3, 1, 4, 4, 4}};
  LoopSurface exact(mesh.view());
  Surface surface(mesh.view());
  exact.update(mesh.positions);
  surface.update(mesh.positions);
  for (std::size_t t = 0; t < 5; ++t) {
    for (const std::array<float, 3> at : {std::array<float, 3>{1, 0, 0}, {0, 0.5F, 0.5F}}) {
      EXPECT_LE(distance(exact.evaluate(t, at).position, surface.evaluate(t, at).position), 1e-6) << t;
      EXPECT_LE(distance(exact.evaluate(t, at).normal, surface.evaluate(t, at).normal), 1e-5) << t;
    }
  }
  std::vector<Sample> samples(5 * 6);
  exact.refine(1, samples);
  for (const Sample& sample : samples)
    EXPECT_NEAR(std::hypot(sample.normal[0], sample.normal[1], sample.normal[2]), 1, 1e-5);
  EXPECT_THROW(exact.refine(1, std::span(samples).first(29)), Error);
  EXPECT_THROW(exact.refine(12, samples), Error);
  EXPECT_THROW(static_cast<void>(exact.evaluate(5, {1, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(exact.evaluate(0, {std::nanf(""), 0, 0})), Error);
}

}  // namespace
}  // namespace glark::qas::test
