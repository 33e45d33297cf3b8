// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/surfel.h>
#include <glark/surfel.h>
#include <gtest/gtest.h>

#include "tests/c_api/shapes.h"

namespace glark::test {
namespace {

class SurfelInC : public testing::Test {
 protected:
  void SetUp() override {
    glark_surfel_options options = glark_surfel_default_options();
    options.levels = 2;
    ASSERT_EQ(GLARK_SUCCESS, glark_surfel_strips_create(&cloud, &options, &strips, &error)) << error.message;
  }
  void TearDown() override { glark_surfel_strips_free(strips); }

  std::vector<float> points = sphere(5000);
  glark_surfel_cloud cloud{array(points), array(points)};
  glark_surfel_strips* strips = nullptr;
  glark_error error{};
  surfel::Strips same{{points, points}, {.levels = 2}};
};

TEST_F(SurfelInC, StripsAndNodesAreThoseOfCpp) {
  EXPECT_EQ(5000U, glark_surfel_strips_point_count(strips));
  EXPECT_EQ(2U, glark_surfel_strips_level_count(strips));
  EXPECT_TRUE(std::ranges::equal(same.indices(), copy(glark_surfel_strips_indices(strips))));
  glark_surfel_nodes nodes;
  ASSERT_EQ(GLARK_SUCCESS, glark_surfel_strips_nodes(strips, 1, &nodes, &error));
  ASSERT_EQ(same.nodes(1).size(), nodes.count);
  EXPECT_EQ(same.nodes(1).back().cone_sine, nodes.data[nodes.count - 1].cone_sine);
  EXPECT_EQ(same.nodes(1).back().first, nodes.data[nodes.count - 1].first);
  EXPECT_EQ(same.nodes(1).back().representative, nodes.data[nodes.count - 1].representative);
  glark_surfel_counts counts;
  ASSERT_EQ(GLARK_SUCCESS, glark_surfel_strips_counts(strips, 0, &counts, &error));
  EXPECT_EQ(same.counts().valid, counts.valid);
  EXPECT_EQ(same.counts().indices, counts.indices);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_surfel_strips_nodes(strips, 2, &nodes, &error));
}

TEST_F(SurfelInC, AFrameIsThatOfCpp) {
  glark_surfel_view view = glark_surfel_default_view();
  surfel::View same_view;
  for (const std::size_t i : {0U, 5U, 10U, 15U}) view.clip_from_object[i] = same_view.clip_from_object.at(i) = 1;
  view.width = same_view.width = view.height = same_view.height = 300;
  glark_surfel_frame* frame = glark_surfel_frame_create();
  ASSERT_EQ(GLARK_SUCCESS, glark_surfel_strips_select(strips, &view, frame, &error)) << error.message;
  surfel::Frame same_frame;
  same.select(same_view, same_frame);
  ASSERT_EQ(same_frame.draws(), glark_surfel_frame_draws(frame));
  EXPECT_GT(same_frame.draws(), 0);
  EXPECT_TRUE(std::equal(same_frame.counts.begin(), same_frame.counts.end(), glark_surfel_frame_counts(frame)));
  EXPECT_TRUE(std::equal(same_frame.offsets.begin(), same_frame.offsets.end(), glark_surfel_frame_offsets(frame)));
  EXPECT_EQ(same_frame.points, copy(glark_surfel_frame_points(frame)));
  EXPECT_EQ(same_frame.visited, glark_surfel_frame_numbers(frame).visited);
  EXPECT_EQ(same_frame.back_faces, glark_surfel_frame_numbers(frame).back_faces);
  glark_surfel_frame_free(frame);
}

TEST_F(SurfelInC, AnUpdateChangesTheRangesOfCpp) {
  const std::vector<std::uint32_t> moved = {2500, 2501};
  points[3 * 2500] += 0.2F;
  points[3 * 2501 + 2] += 0.1F;
  const std::vector<surfel::Range> expected = same.update({points, points}, moved);
  glark_surfel_ranges ranges;
  ASSERT_EQ(GLARK_SUCCESS, glark_surfel_strips_update(strips, &cloud, array(moved), &ranges, &error)) << error.message;
  ASSERT_EQ(expected.size(), ranges.count);
  ASSERT_GT(ranges.count, 0U);
  EXPECT_EQ(expected.back().first, ranges.data[ranges.count - 1].first);
  EXPECT_EQ(expected.back().count, ranges.data[ranges.count - 1].count);
  EXPECT_TRUE(std::ranges::equal(same.indices(), copy(glark_surfel_strips_indices(strips))));
}

TEST_F(SurfelInC, AnErrorNamesTheElement) {
  points[3 * 17 + 2] = INFINITY;
  glark_surfel_strips* none = nullptr;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_surfel_strips_create(&cloud, nullptr, &none, &error));
  EXPECT_EQ(GLARK_SURFEL_POINT, error.element) << error.message;
  EXPECT_EQ(17U, error.index);
  EXPECT_EQ(nullptr, none);
}

}  // namespace

TEST(SurfelNullInC, ANullObjectHasNothing) {
  EXPECT_EQ(0u, glark_surfel_strips_indices(nullptr).count);
  EXPECT_EQ(nullptr, glark_surfel_frame_counts(nullptr));
  EXPECT_EQ(nullptr, glark_surfel_frame_offsets(nullptr));
  EXPECT_EQ(0, glark_surfel_frame_draws(nullptr));
  EXPECT_EQ(0u, glark_surfel_frame_numbers(nullptr).strips);
}

}  // namespace glark::test
