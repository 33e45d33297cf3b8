// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --max-error is a bound of the measured distance.
#include "glark/tool/scan/simplify/within_error.h"

#include <gtest/gtest.h>

#include <utility>

#include "glark/clients/geometry/measure/distance.h"
#include "tests/shapes/parts.h"

namespace glark::tool {
namespace {

geometry::Geometry mesh_of(shapes::Part part) {
  geometry::Geometry mesh;
  mesh.positions = std::move(part.positions);
  mesh.triangles = std::move(part.triangles);
  return mesh;
}

vstree::SimplifyOptions within(float error, std::size_t target = 0) {
  return {.target = target, .threads = 1, .method = vstree::Method::automatic, .max_error = error};
}

double error_of(const geometry::Geometry& coarse, const geometry::Geometry& mesh) {
  return geometry::distance_between(coarse, mesh, {}).hausdorff() / geometry::diagonal_of(mesh);
}

TEST(WithinError, TheMeasuredDistanceIsWithinTheBound) {
  constexpr float most = 1e-3F;
  std::size_t estimates_that_fail = 0;
  for (unsigned seed = 1; seed < 4; ++seed) {
    for (const auto make : {shapes::gear, shapes::bracket, shapes::cup}) {
      const geometry::Geometry mesh = mesh_of(make(seed, 1));
      const Coarse coarse = simplified_within_error(mesh, within(most));
      EXPECT_LT(coarse.geometry.triangle_count(), mesh.triangle_count());
      ASSERT_TRUE(coarse.measured);
      EXPECT_LE(*coarse.measured, most);
      EXPECT_NEAR(*coarse.measured, error_of(coarse.geometry, mesh), 1e-12);
      estimates_that_fail += error_of(simplified(mesh, within(most)).geometry, mesh) > most ? 1 : 0;
    }
  }
  EXPECT_GT(estimates_that_fail, 0U);
}

// Vertices of sheets that touch move apart, but by less than the bound.
TEST(WithinError, TouchingPartsHaveFewerTrianglesToo) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    const geometry::Geometry mesh = mesh_of(shapes::assembly(seed, 1));
    const Coarse coarse = simplified_within_error(mesh, within(1e-4F));
    EXPECT_LT(coarse.geometry.triangle_count(), mesh.triangle_count() / 2);
    EXPECT_LE(error_of(coarse.geometry, mesh), 1e-4);
  }
}

TEST(WithinError, ALooserBoundNeedsFewerTriangles) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    const geometry::Geometry mesh = mesh_of(shapes::blob(seed, 1));
    std::size_t last = mesh.triangle_count();
    for (const float most : {1e-3F, 3e-3F, 1e-2F}) {
      const std::size_t count = simplified_within_error(mesh, within(most)).geometry.triangle_count();
      EXPECT_LT(count, last);
      last = count;
    }
  }
}

TEST(WithinError, TheTargetAlsoHoldsIfTheErrorAllowsIt) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    const geometry::Geometry mesh = mesh_of(shapes::blob(seed, 1));
    const std::size_t count = mesh.triangle_count();
    const Coarse reached = simplified_within_error(mesh, within(1e-2F, count / 4));
    EXPECT_LE(reached.geometry.triangle_count(), count / 4);
    EXPECT_GT(reached.geometry.triangle_count(), count / 5);
    const Coarse stopped = simplified_within_error(mesh, within(1e-3F, 20));
    EXPECT_GT(stopped.geometry.triangle_count(), 20U);
    EXPECT_LE(error_of(stopped.geometry, mesh), 1e-3F);
  }
}

// No triangle is left at any bound that the search tries.
TEST(WithinError, OrElseTheResultIsTheWholeMesh) {
  geometry::Geometry mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  const Coarse coarse = simplified_within_error(mesh, within(1e-9F));
  EXPECT_EQ(coarse.geometry.triangles, mesh.triangles);
  EXPECT_EQ(coarse.measured, 0);
}

}  // namespace
}  // namespace glark::tool
