// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/vstree.h>
#include <glark/vstree.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

const std::vector<float> points = sphere(3000);
const glark_vstree_point_set samples{array(points), array(points), {}, {}};

TEST(VstreeInC, TheTreeIsThatOfCpp) {
  glark_vstree_options options = glark_vstree_default_options();
  options.threshold = 1e-3F;
  options.metric = GLARK_VSTREE_QEF;
  glark_vstree_tree* tree = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS, glark_vstree_tree_create(&samples, &options, &tree, &error)) << error.message;
  const vstree::Tree same({.positions = points, .normals = points},
                          {.metric = vstree::Metric::qef, .threshold = 1e-3F});
  const glark_vstree_nodes nodes = glark_vstree_tree_nodes(tree);
  ASSERT_EQ(same.nodes().size(), nodes.count);
  for (std::size_t i = 0; i < nodes.count; ++i) {
    EXPECT_EQ(same.nodes()[i].begin, nodes.data[i].begin);
    EXPECT_EQ(same.nodes()[i].end, nodes.data[i].end);
    EXPECT_EQ(same.nodes()[i].first_child, nodes.data[i].first_child);
    EXPECT_EQ(static_cast<int>(same.nodes()[i].kind), nodes.data[i].kind);
    EXPECT_EQ(same.nodes()[i].joined, nodes.data[i].joined);
  }
  const glark_vstree_frames frames = glark_vstree_tree_frames(tree);
  ASSERT_EQ(same.frames().size(), frames.count);
  ASSERT_GT(frames.count, 0U);
  EXPECT_EQ(same.frames().back().normal[2], frames.data[frames.count - 1].normal[2]);
  EXPECT_EQ(same.frames().back().node, frames.data[frames.count - 1].node);
  EXPECT_TRUE(std::ranges::equal(same.order(), copy(glark_vstree_tree_order(tree))));
  EXPECT_EQ(same.leaf_count(), glark_vstree_tree_leaf_count(tree));
  EXPECT_EQ(same.bytes(), glark_vstree_tree_bytes(tree));
  EXPECT_EQ(same.diagonal(), glark_vstree_tree_diagonal(tree));
  const float outside[3] = {9, 9, 9};
  EXPECT_EQ(static_cast<std::uint32_t>(GLARK_VSTREE_NONE), glark_vstree_tree_leaf_of(tree, outside));
  EXPECT_EQ(same.leaf_of({points[0], points[1], points[2]}), glark_vstree_tree_leaf_of(tree, points.data()));
  glark_vstree_tree_free(tree);
}

TEST(VstreeInC, NormalsAreThoseOfCpp) {
  const glark_vstree_point_set bare{array(points), {}, {}, {}};
  std::vector<float> normals(points.size());
  glark_error error;
  const std::array<float, 3> eye = {0, 0, 5};
  glark_vstree_normal_options options = glark_vstree_default_normal_options();
  ASSERT_EQ(GLARK_SUCCESS, glark_vstree_estimate_normals(&bare, nullptr, output(normals), &error)) << error.message;
  EXPECT_EQ(vstree::estimate_normals({.positions = points}), normals);
  options.scanner = eye.data();
  options.neighbours = 8;
  ASSERT_EQ(GLARK_SUCCESS, glark_vstree_estimate_normals(&bare, &options, output(normals), &error)) << error.message;
  EXPECT_EQ(vstree::estimate_normals({.positions = points}, {.neighbours = 8, .scanner = &eye}), normals);
  normals.pop_back();
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_vstree_estimate_normals(&bare, &options, output(normals), &error));
  EXPECT_TRUE(contains(error, "glark-vstree: array normals has 8999 numbers for 9000")) << error.message;
}

TEST(VstreeInC, SimplificationIsThatOfCpp) {
  std::vector<std::uint8_t> colours(points.size());
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint8_t>(i % 251);
  glark_vstree_mesh mesh{samples, {}};
  mesh.points.colours = {colours.data(), colours.size()};
  glark_vstree_simplify_options options = glark_vstree_default_simplify_options();
  options.target = 300;
  options.representative = GLARK_VSTREE_CENTROID;
  glark_vstree_simplified* simplified = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS, glark_vstree_simplify(&mesh, &options, &simplified, &error)) << error.message;
  const vstree::Simplified same =
      vstree::simplify({.points = {.positions = points, .normals = points, .colours = colours}},
                       {.representative = vstree::Representative::centroid, .target = 300});
  EXPECT_GT(same.positions.size(), 600U);
  EXPECT_EQ(same.positions, copy(glark_vstree_simplified_positions(simplified)));
  EXPECT_EQ(same.normals, copy(glark_vstree_simplified_normals(simplified)));
  EXPECT_EQ(same.colours, copy(glark_vstree_simplified_colours(simplified)));
  EXPECT_EQ(same.texcoords, copy(glark_vstree_simplified_texcoords(simplified)));
  EXPECT_EQ(same.triangles, copy(glark_vstree_simplified_triangles(simplified)));
  EXPECT_EQ(same.representatives, copy(glark_vstree_simplified_representatives(simplified)));
  glark_vstree_simplified_free(simplified);
}

TEST(VstreeInC, CollapseIsThatOfCpp) {
  const std::vector<float> corners{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
  const std::vector<std::uint32_t> triangles{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  glark_vstree_mesh mesh{};
  mesh.points.positions = {corners.data(), corners.size()};
  mesh.triangles = {triangles.data(), triangles.size()};
  glark_vstree_simplify_options options = glark_vstree_default_simplify_options();
  EXPECT_EQ(GLARK_VSTREE_CLUSTER, options.method);
  options.method = GLARK_VSTREE_COLLAPSE;
  options.max_error = 0.01F;
  glark_vstree_simplified* simplified = nullptr;
  glark_error error;
  ASSERT_EQ(GLARK_SUCCESS, glark_vstree_simplify(&mesh, &options, &simplified, &error)) << error.message;
  const vstree::Simplified same =
      vstree::simplify({{.positions = corners}, triangles}, {.method = vstree::Method::collapse, .max_error = 0.01F});
  EXPECT_EQ(6U, same.triangles.size());  // two triangles
  EXPECT_EQ(same.triangles, copy(glark_vstree_simplified_triangles(simplified)));
  EXPECT_EQ(GLARK_VSTREE_COLLAPSE, glark_vstree_simplified_method(simplified));
  EXPECT_EQ(same.error, glark_vstree_simplified_error(simplified));
  glark_vstree_simplified_free(simplified);
}

TEST(VstreeInC, AnUnknownEnumerationIsAnError) {
  glark_vstree_options options = glark_vstree_default_options();
  const unsigned unknown = 7;  // C would not refuse it
  std::memcpy(&options.metric, &unknown, sizeof unknown);
  glark_vstree_tree* tree = nullptr;
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_vstree_tree_create(&samples, &options, &tree, &error));
  EXPECT_EQ(GLARK_VSTREE_OPTION, error.element);
  EXPECT_STREQ("glark-vstree: option metric is 7; use a value of its enumeration", error.message);
}

TEST(VstreeInC, AnImpossibleCountIsAnErrorBeforeAnythingIsRead) {
  const glark_vstree_mesh mesh = {samples, {octahedron_triangles.data(), SIZE_MAX}};
  glark_vstree_simplified* simplified = nullptr;
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_vstree_simplify(&mesh, nullptr, &simplified, &error));
  EXPECT_TRUE(contains(error, "check its count")) << error.message;
}

TEST(VstreeInC, AScannerThatIsNotFiniteIsAnError) {
  const glark_vstree_point_set bare{array(points), {}, {}, {}};
  std::vector<float> normals(points.size());
  const std::array<float, 3> nowhere = {0, NAN, 0};
  glark_vstree_normal_options options = glark_vstree_default_normal_options();
  options.scanner = nowhere.data();
  glark_error error;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_vstree_estimate_normals(&bare, &options, output(normals), &error));
  EXPECT_TRUE(contains(error, "scanner is not finite")) << error.message;
}

}  // namespace

TEST(VstreeNullInC, ANullObjectHasNothing) {
  const float origin[3] = {0, 0, 0};
  EXPECT_EQ(0u, glark_vstree_tree_nodes(nullptr).count);
  EXPECT_EQ(0xffffffffu, glark_vstree_tree_leaf_of(nullptr, origin));
  EXPECT_EQ(0u, glark_vstree_simplified_positions(nullptr).count);
}

}  // namespace glark::test
