// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/reconstruct.h>
#include <glark/reconstruct.h>
#include <gtest/gtest.h>

#include <string_view>

#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

TEST(ReconstructInC, TheMeshIsThatOfCpp) {
  const std::vector<float> points = sphere(2000);
  const std::vector<std::uint8_t> colours(points.size(), 200);
  const glark_vstree_point_set samples{array(points), array(points), {colours.data(), colours.size()}, {}};
  glark_reconstruct_options options = glark_reconstruct_default_options();
  options.levels = 1;
  glark_reconstruct_mesh* mesh = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS, glark_reconstruct(&samples, &options, &mesh, &error)) << error.message;
  const reconstruct::Reconstructed same =
      reconstruct::reconstruct({.positions = points, .normals = points, .colours = colours}, {.levels = 1});
  EXPECT_EQ(same.positions, copy(glark_reconstruct_positions(mesh)));
  EXPECT_EQ(same.normals, copy(glark_reconstruct_normals(mesh)));
  EXPECT_EQ(same.colours, copy(glark_reconstruct_colours(mesh)));
  EXPECT_EQ(same.triangles, copy(glark_reconstruct_triangles(mesh)));
  EXPECT_FALSE(same.triangles.empty());
  const glark_reconstruct_counts counts = glark_reconstruct_mesh_counts(mesh);
  EXPECT_EQ(same.base_vertices, counts.base_vertices);
  EXPECT_EQ(same.base_triangles, counts.base_triangles);
  EXPECT_EQ(same.levels, counts.levels);
  EXPECT_EQ(same.node_side, counts.node_side);
  EXPECT_EQ(same.noise, counts.noise);
  EXPECT_EQ(same.left_out, counts.left_out);
  glark_reconstruct_mesh_free(mesh);
}

TEST(ReconstructInC, AnErrorNamesTheElement) {
  std::vector<float> points = sphere(100);
  points[3 * 42] = NAN;
  const glark_vstree_point_set samples{array(points), {}, {}, {}};
  glark_reconstruct_mesh* mesh = nullptr;
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_reconstruct(&samples, nullptr, &mesh, &error));
  EXPECT_EQ(GLARK_VSTREE_POINT, error.element) << error.message;
  EXPECT_EQ(42U, error.index);
  EXPECT_TRUE(std::string_view(error.message).starts_with("glark-reconstruct: point 42")) << error.message;
  EXPECT_EQ(nullptr, mesh);
}

}  // namespace

TEST(ReconstructInC, ANullObjectHasNothing) {
  EXPECT_EQ(0u, glark_reconstruct_positions(nullptr).count);
  EXPECT_EQ(0u, glark_reconstruct_mesh_counts(nullptr).levels);
}

TEST(ReconstructNullInC, ANullObjectHasNothing) {
  EXPECT_EQ(0u, glark_reconstruct_positions(nullptr).count);
  EXPECT_EQ(0u, glark_reconstruct_mesh_counts(nullptr).levels);
}

}  // namespace glark::test
