// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/qas.h>
#include <glark/qas.h>
#include <gtest/gtest.h>

#include <cstring>
#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

const glark_qas_mesh mesh{6, array(octahedron_triangles), {}};
const qas::Mesh same_mesh{6, octahedron_triangles};
const float weights[3] = {0.5F, 0.25F, 0.25F};

void expect_same(const qas::Sample& expected, const glark_qas_sample& sample) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(expected.position.at(i), sample.position[i]);
    EXPECT_EQ(expected.normal.at(i), sample.normal[i]);
  }
}

class QasInC : public testing::Test {
 protected:
  void SetUp() override {
    glark_qas_options options = glark_qas_default_options();
    options.splits = 1;
    ASSERT_EQ(GLARK_SUCCESS, glark_qas_surface_create(&mesh, &options, &surface, &error)) << error.message;
    ASSERT_EQ(GLARK_SUCCESS, glark_qas_surface_update(surface, array(octahedron), &error)) << error.message;
    same.update(octahedron);
  }
  void TearDown() override { glark_qas_surface_free(surface); }

  glark_qas_surface* surface = nullptr;
  glark_error error{};
  qas::Surface same{same_mesh, {.splits = 1}};
};

TEST_F(QasInC, ArraysAreThoseOfCpp) {
  const glark_floats limits = glark_qas_surface_limit_positions(surface);
  const glark_floats normals = glark_qas_surface_limit_normals(surface);
  ASSERT_EQ(4 * same.limit_positions().size(), limits.count);
  ASSERT_EQ(4 * same.limit_normals().size(), normals.count);
  EXPECT_EQ(same.limit_positions().back().z, limits.data[limits.count - 2]);
  EXPECT_EQ(same.limit_normals().back().y, normals.data[normals.count - 3]);
  const glark_qas_patches patches = glark_qas_surface_patches(surface);
  ASSERT_EQ(same.patches().size(), patches.count);
  EXPECT_EQ(same.patches().back().normals[5], patches.data[patches.count - 1].normals[5]);
  const std::vector<std::uint32_t> vertices = copy(glark_qas_surface_corner_vertices(surface));
  ASSERT_EQ(2 * same.corner_vertices().size(), vertices.size());
  EXPECT_EQ(same.corner_vertices().back()[0], vertices[vertices.size() - 2]);
}

TEST_F(QasInC, CornersAndSamplesAreThoseOfCpp) {
  std::vector<glark_qas_corner> corners(glark_qas_surface_corner_count(surface));
  std::vector<qas::Corner> same_corners(same.corner_count());
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_surface_write_corners(surface, corners.data(), corners.size(), &error));
  same.write_corners(same_corners);
  ASSERT_EQ(same_corners.size(), corners.size());
  EXPECT_EQ(same_corners.back().edge_normal[1], corners.back().edge_normal[1]);
  std::vector<glark_qas_quartic_corner> quartic(glark_qas_surface_quartic_corner_count(surface));
  std::vector<qas::QuarticCorner> same_quartic(same.quartic_corner_count());
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_surface_write_quartic_corners(surface, quartic.data(), quartic.size(), &error));
  same.write_quartic_corners(same_quartic);
  EXPECT_EQ(same_quartic.back().normals[3][2], quartic.back().normals[3][2]);
  glark_qas_sample sample;
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_surface_evaluate(surface, 3, weights, &sample, &error));
  expect_same(same.evaluate(3, {0.5F, 0.25F, 0.25F}), sample);
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_surface_evaluate_quartic(surface, 2, weights, &sample, &error));
  expect_same(same.evaluate_quartic(2, {0.5F, 0.25F, 0.25F}), sample);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_qas_surface_write_corners(surface, corners.data(), 1, &error));
  EXPECT_EQ(GLARK_QAS_ARRAY, error.element) << error.message;
}

TEST(QasOptionsInC, AnUnknownSchemeIsAnError) {
  glark_qas_options options = glark_qas_default_options();
  const unsigned unknown = 7;  // C would not refuse it
  std::memcpy(&options.scheme, &unknown, sizeof unknown);
  glark_qas_surface* surface = nullptr;
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_qas_surface_create(&mesh, &options, &surface, &error));
  EXPECT_TRUE(contains(error, "scheme is 7")) << error.message;
  EXPECT_EQ(nullptr, surface);
}

TEST(LoopInC, TheSurfaceIsThatOfCpp) {
  glark_qas_loop_surface* surface = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_loop_surface_create(&mesh, &surface, &error)) << error.message;
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_loop_surface_update(surface, array(octahedron), &error));
  qas::LoopSurface same(same_mesh);
  same.update(octahedron);
  glark_qas_sample sample;
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_loop_surface_evaluate(surface, 5, weights, &sample, &error));
  expect_same(same.evaluate(5, {0.5F, 0.25F, 0.25F}), sample);
  std::vector<glark_qas_sample> samples(8 * 6);
  std::vector<qas::Sample> same_samples(8 * 6);
  ASSERT_EQ(GLARK_SUCCESS, glark_qas_loop_surface_refine(surface, 1, samples.data(), samples.size(), 1, &error))
      << error.message;
  same.refine(1, same_samples, 1);
  expect_same(same_samples.back(), samples.back());
  glark_qas_loop_surface_free(surface);
}

// An uninitialised count took gigabytes and minutes.
TEST(QasCountInC, ManyVerticesOfFewTrianglesAreRefused) {
  const std::vector<std::uint32_t> triangle{0, 1, 2};
  glark_error error;
  for (const std::size_t count : {std::size_t{1} << 23U, std::size_t{1} << 31U, SIZE_MAX}) {
    const glark_qas_mesh mesh{count, array(triangle), {}};
    glark_qas_surface* surface = nullptr;
    EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_qas_surface_create(&mesh, nullptr, &surface, &error));
    EXPECT_EQ(GLARK_QAS_MESH, error.element) << error.message;
    glark_qas_loop_surface* loop = nullptr;
    EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_qas_loop_surface_create(&mesh, &loop, &error));
    EXPECT_EQ(nullptr, surface);
    EXPECT_EQ(nullptr, loop);
  }
  const glark_qas_mesh unused{1000, array(triangle), {}};
  glark_qas_surface* surface = nullptr;
  EXPECT_EQ(GLARK_SUCCESS, glark_qas_surface_create(&unused, nullptr, &surface, &error)) << error.message;
  glark_qas_surface_free(surface);
}

TEST(QasTextInC, NamesAreThoseGiven) {
  char* text = glark_qas_refinement_shader(nullptr);
  EXPECT_EQ(qas::refinement_shader(), text);
  glark_qas_text_free(text);
  const glark_qas_shader_inputs inputs{nullptr, "edge", nullptr, nullptr};
  text = glark_qas_refinement_shader(&inputs);
  EXPECT_EQ(qas::refinement_shader({.edge_position = "edge"}), text);
  glark_qas_text_free(text);
  text = glark_qas_quartic_refinement_shader("p", "n");
  EXPECT_EQ(qas::quartic_refinement_shader("p", "n"), text);
  glark_qas_text_free(text);
  glark_qas_text_free(nullptr);
}

}  // namespace

TEST(LoopInC, ANullObjectHasNothing) {
  EXPECT_EQ(0u, glark_qas_surface_limit_positions(nullptr).count);
  EXPECT_EQ(0u, glark_qas_surface_corner_vertices(nullptr).count);
  EXPECT_EQ(0u, glark_qas_surface_corner_count(nullptr));
}

TEST(QasNullInC, ANullObjectHasNothing) {
  EXPECT_EQ(0u, glark_qas_surface_limit_positions(nullptr).count);
  EXPECT_EQ(0u, glark_qas_surface_corner_vertices(nullptr).count);
  EXPECT_EQ(0u, glark_qas_surface_corner_count(nullptr));
}

}  // namespace glark::test
