// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/depth.h>
#include <glark/depth.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

class DepthInC : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(GLARK_SUCCESS, glark_depth_tagger_create(6, array(octahedron_triangles), 5, &tagger, &error));
  }
  void TearDown() override { glark_depth_tagger_free(tagger); }

  // Both give the same six tags.
  template <class Step>
  void expect_tags(glark_code code, const Step& in_cpp) {
    EXPECT_EQ(GLARK_SUCCESS, code) << error.message;
    std::vector<float> expected(6, -1);
    in_cpp(std::span<float>(expected));
    EXPECT_EQ(expected, tags);
  }

  glark_depth_tagger* tagger = nullptr;
  glark_error error{};
  depth::Tagger same{6, octahedron_triangles, 5};
  std::vector<float> tags = std::vector<float>(6, -2);
};

TEST_F(DepthInC, Distance) {
  glark_depth_distance_range range = glark_depth_default_distance_range();
  range.point[0] = 1.5F;
  range.farthest = 3;
  expect_tags(glark_depth_by_distance(tagger, array(octahedron), &range, output(tags), &error), [&](auto t) {
    same.by_distance(octahedron, {.point = {1.5F, 0, 0}, .farthest = 3}, t);
  });
}

TEST_F(DepthInC, EdgeLengthAndCurvature) {
  glark_depth_view view = glark_depth_default_view();
  view.eye[2] = 4;
  const depth::View same_view{.eye = {0, 0, 4}};
  expect_tags(glark_depth_by_edge_length(tagger, array(octahedron), &view, 20, output(tags), &error),
              [&](auto t) { same.by_edge_length(octahedron, same_view, 20, t); });
  expect_tags(glark_depth_by_curvature(tagger, array(octahedron), array(octahedron), 0.01F, output(tags), &error),
              [&](auto t) { same.by_curvature(octahedron, octahedron, 0.01F, t); });
  expect_tags(glark_depth_by_curvature_on_screen(tagger, array(octahedron), {}, &view, 2, output(tags), &error),
              [&](auto t) { same.by_curvature(octahedron, {}, same_view, 2, t); });
}

TEST_F(DepthInC, DisplacementAndCurvatures) {
  const std::vector<float> heights = {0, 1, 0, 1, 0, 1, 0, 1, 0};
  const std::vector<float> coordinates = {0, 0, 1, 0, 0, 1, 1, 1, 0.3F, 0.4F, 0.9F, 0.2F};
  const glark_depth_height_map map{array(heights), 3, 3};
  expect_tags(glark_depth_by_displacement(tagger, array(coordinates), &map, 0.05F, output(tags), &error), [&](auto t) {
    same.by_displacement(coordinates, {heights, 3, 3}, 0.05F, t);
  });
  std::vector<float> lesser(6);
  std::vector<float> same_lesser(6);
  expect_tags(glark_depth_principal_curvatures(tagger, array(octahedron), array(octahedron), output(tags),
                                               output(lesser), &error),
              [&](auto t) { same.principal_curvatures(octahedron, octahedron, t, same_lesser); });
  EXPECT_EQ(same_lesser, lesser);
}

TEST_F(DepthInC, TagsAreCombinedAndCounted) {
  const std::vector<float> first = {0, 1, 2, 3, 4, 5};
  const std::vector<float> other = {3, 3, 3, 0, 0, 0};
  const auto start = [&] { ASSERT_EQ(GLARK_SUCCESS, glark_depth_manual(tagger, array(first), output(tags), &error)); };
  start();
  glark_depth_take_greater(tagger, array(other), output(tags), &error);
  EXPECT_EQ((std::vector<float>{3, 3, 3, 3, 4, 5}), tags);
  start();
  glark_depth_take_lesser(tagger, array(other), output(tags), &error);
  EXPECT_EQ((std::vector<float>{0, 1, 2, 0, 0, 0}), tags);
  start();
  glark_depth_blend(tagger, array(other), 0.5F, output(tags), &error);
  EXPECT_EQ((std::vector<float>{1.5F, 2, 2.5F, 1.5F, 2, 2.5F}), tags);

  start();
  std::uint64_t triangles = 0;
  for (const auto rule : {GLARK_DEPTH_ROUNDED, GLARK_DEPTH_GEOMORPH}) {
    ASSERT_EQ(GLARK_SUCCESS, glark_depth_refined_triangles(tagger, array(tags), rule, &triangles, &error));
    EXPECT_EQ(same.refined_triangles(first, static_cast<depth::EdgeRule>(rule)), triangles);
  }
  glark_depth_budget budget{};
  ASSERT_EQ(GLARK_SUCCESS, glark_depth_keep_budget(tagger, 100, output(tags), GLARK_DEPTH_ROUNDED, &budget, &error));
  std::vector<float> expected = first;
  const depth::Budget same_budget = same.keep_budget(100, expected);
  EXPECT_EQ(expected, tags);
  EXPECT_EQ(same_budget.bias, budget.bias);
  EXPECT_EQ(same_budget.triangles, budget.triangles);
  EXPECT_EQ(same_budget.kept, budget.kept);
}

TEST_F(DepthInC, BadArgumentsAreCodesAndText) {
  const std::vector<std::uint32_t> beyond = {0, 1, 6};
  glark_depth_tagger* none = nullptr;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_depth_tagger_create(6, array(beyond), 5, &none, &error));
  EXPECT_EQ(nullptr, none);
  EXPECT_TRUE(contains(error, "6")) << error.message;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_depth_manual(nullptr, array(tags), output(tags), &error));
  EXPECT_TRUE(contains(error, "tagger is NULL")) << error.message;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_depth_manual(tagger, {nullptr, 6}, output(tags), nullptr));
  EXPECT_EQ(std::vector<float>(6, -2), tags);
  glark_depth_tagger_free(nullptr);
}

TEST_F(DepthInC, AnUnknownEnumerationIsAnError) {
  glark_depth_edge_rule rule = GLARK_DEPTH_ROUNDED;
  const unsigned unknown = 7;  // C would not refuse it
  std::memcpy(&rule, &unknown, sizeof unknown);
  std::uint64_t triangles = 99;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_depth_refined_triangles(tagger, array(tags), rule, &triangles, &error));
  EXPECT_TRUE(contains(error, "rule is 7")) << error.message;
  EXPECT_EQ(99U, triangles);
}

TEST_F(DepthInC, AnImpossibleCountIsAnErrorBeforeAnythingIsRead) {
  glark_depth_tagger* none = nullptr;
  EXPECT_EQ(GLARK_BAD_ARGUMENT,
            glark_depth_tagger_create(6, {octahedron_triangles.data(), SIZE_MAX}, 5, &none, &error));
  EXPECT_TRUE(contains(error, "check its count")) << error.message;
  EXPECT_EQ(nullptr, none);
}

}  // namespace
}  // namespace glark::test
