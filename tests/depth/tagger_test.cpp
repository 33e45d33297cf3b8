// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <glark/depth.h>

#include "tests/common/allocations.h"
#include "tests/depth/meshes.h"

namespace glark::depth {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t square[] = {0, 1, 2, 0, 2, 3};
constexpr float square_positions[] = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0};

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Tagger, ManualTagsAreClamped) {
  const Tagger tagger(4, square, 5);
  std::vector<float> tags(4);
  tagger.manual(std::vector<float>{-1, 0.5F, 5, 9}, tags);
  EXPECT_EQ(tags, (std::vector<float>{0, 0.5F, 5, 5}));
}

TEST(Tagger, DistanceMapsItsRange) {
  const Tagger tagger(4, square, 6);
  std::vector<float> tags(4);
  tagger.by_distance(square_positions, {.point = {0, 0, 0}, .nearest = 2, .farthest = 6, .finest = 5, .coarsest = 1},
                     tags);
  EXPECT_EQ(tags[0], 5.0F);
  EXPECT_FLOAT_EQ(tags[1], 3.0F);
  EXPECT_NEAR(tags[2], 5 - (std::sqrt(32.0F) - 2), 1e-5F);
}

TEST(Tagger, EdgeLengthHalvesUntilItFits) {
  Tagger tagger(4, square, 6);
  std::vector<float> tags(4);
  // Seen from (2, 2, 100), each edge of the square covers about 4 * 100 / 100 = 4 pixels, and the diagonal 5.66.
  const View view{.eye = {2, 2, 100}, .pixels_at_one = 100};
  tagger.by_edge_length(square_positions, view, 1, tags);
  EXPECT_NEAR(tags[0], std::log2(std::sqrt(32.0F)), 1e-3F);
  EXPECT_NEAR(tags[1], 2.0F, 1e-3F);
  tagger.by_edge_length(square_positions, view, 8, tags);
  EXPECT_EQ(tags[0], 0.0F);
}

TEST(Tagger, AnEyeOnTheEdgeGivesTheDeepestLevel) {
  Tagger tagger(4, square, 6);
  std::vector<float> tags(4);
  tagger.by_edge_length(square_positions, {.eye = {2, 0, 0}}, 4, tags);
  EXPECT_EQ(tags[0], 6.0F);
  EXPECT_EQ(tags[1], 6.0F);
}

TEST(Tagger, DisplacementSeesWhatInterpolationMisses) {
  Tagger tagger(4, square, 8);
  std::vector<float> tags(4, -1.0F);
  const std::vector<float> coordinates = {0.125F, 0.125F, 0.875F, 0.125F, 0.875F, 0.875F, 0.125F, 0.875F};
  std::vector<float> heights(64);
  for (std::size_t i = 0; i < 64; ++i) heights[i] = 0.5F * static_cast<float>(i % 8);  // a ramp
  tagger.by_displacement(coordinates, {heights, 8, 8}, 1e-4F, tags);
  for (float tag : tags) EXPECT_EQ(tag, 0.0F);
  heights.assign(64, 0.0F);
  heights[2 * 8 + 5] = 3.0F;  // a peak in triangle 0
  tagger.by_displacement(coordinates, {heights, 8, 8}, 0.01F, tags);
  EXPECT_EQ(tags[3], 0.0F);
  EXPECT_GT(tags[1], 4.0F);
  EXPECT_NEAR(tags[1] - tags[0], 0.5F, 1e-3F);  // the mean over two triangles, one of them flat
  const float once = tags[1];
  for (float& height : heights) height *= 2;
  tagger.by_displacement(coordinates, {heights, 8, 8}, 0.01F, tags);
  EXPECT_NEAR(tags[1] - once, 1.0F, 1e-4F);
}

TEST(Tagger, MetricsCombine) {
  const Tagger tagger(4, square, 5);
  const std::vector<float> other = {1, 2, 3, 9};
  std::vector<float> tags = {3, 2, 1, 0};
  tagger.take_greater(other, tags);
  EXPECT_EQ(tags, (std::vector<float>{3, 2, 3, 5}));
  tags = {3, 2, 1, 0};
  tagger.take_lesser(other, tags);
  EXPECT_EQ(tags, (std::vector<float>{1, 2, 1, 0}));
  tagger.blend(other, 0.25F, tags);
  EXPECT_EQ(tags, (std::vector<float>{1, 2, 1.5F, 1.25F}));
}

TEST(Tagger, AnIsolatedVertexHasNoDepthOfEdges) {
  Tagger tagger(5, square, 6);
  std::vector<float> positions(square_positions, square_positions + 12);
  positions.insert(positions.end(), {0, 0, 0});
  std::vector<float> tags(5, -1.0F);
  tagger.by_edge_length(positions, {.eye = {0, 0, 1}}, 1, tags);
  EXPECT_EQ(tags[4], 0.0F);
}

TEST(Tagger, AnEmptyMeshHasNoTags) {
  Tagger tagger(0, {}, 6);
  tagger.by_distance({}, {}, {});
  tagger.by_curvature({}, {}, 1.0F, {});
  EXPECT_EQ(tagger.refined_triangles({}), 0U);
  EXPECT_TRUE(tagger.keep_budget(0, {}).kept);
}

TEST(Tagger, MeshesThatAreNoneAreRejected) {
  const std::uint32_t outside[] = {0, 1, 2, 2, 7, 0};
  EXPECT_NE(error_of([&] { Tagger(4, outside, 6); }).find("triangle 1 has the vertex 7; there are 4"),
            std::string::npos);
  EXPECT_NE(error_of([&] { Tagger(4, std::span(square).first(4), 6); }).find("4 indices"), std::string::npos);
  EXPECT_NE(error_of([&] { Tagger(4, square, 12); }).find("level 12 exceeds 11"), std::string::npos);
  const std::size_t too_many = (std::size_t{1} << 28) + 1;
  EXPECT_NE(error_of([&] { Tagger(too_many, square, 5); }).find("are more than 2^28"), std::string::npos);
}

TEST(Tagger, BadInputNamesTheVertexAndWritesNothing) {
  Tagger tagger(4, square, 6);
  std::vector<float> positions(square_positions, square_positions + 12);
  std::vector<float> tags(4, -7.0F);
  positions[7] = nan;
  EXPECT_NE(error_of([&] { tagger.by_distance(positions, {}, tags); }).find("vertex 2"), std::string::npos);
  EXPECT_NE(error_of([&] { tagger.by_curvature(positions, {}, 1, tags); }).find("vertex 2"), std::string::npos);
  positions[7] = infinity;
  EXPECT_NE(error_of([&] { tagger.by_edge_length(positions, {}, 1, tags); }).find("vertex 2"), std::string::npos);
  positions.pop_back();
  EXPECT_NE(error_of([&] { tagger.by_distance(positions, {}, tags); }).find("has 11 floats; 4 vertices need 12"),
            std::string::npos);
  std::vector<float> few(3);
  EXPECT_NE(error_of([&] { tagger.by_distance(square_positions, {}, few); }), "");
  EXPECT_NE(error_of([&] { tagger.by_distance(square_positions, {.nearest = 3, .farthest = 3}, tags); }), "");
  EXPECT_NE(error_of([&] { tagger.by_edge_length(square_positions, {}, 0, tags); }), "");
  EXPECT_NE(error_of([&] { tagger.by_curvature(square_positions, {}, nan, tags); }), "");
  const std::vector<float> normals = {0, 0, 1, 0, 0, nan, 0, 0, 1, 0, 0, 1};
  EXPECT_NE(error_of([&] { tagger.by_curvature(square_positions, normals, 1, tags); }).find("normal of vertex 1"),
            std::string::npos);
  const float heights[] = {0, nan, 0, 0};
  const std::vector<float> coordinates(8, 0.0F);
  EXPECT_NE(error_of([&] {
              tagger.by_displacement(coordinates, {heights, 2, 2}, 1, tags);
            }).find("height 1"),
            std::string::npos);
  EXPECT_NE(error_of([&] { tagger.by_displacement(coordinates, {heights, 2, 3}, 1, tags); }), "");
  EXPECT_NE(error_of([&] {
              tagger.take_greater(std::vector<float>{0, nan, 0, 0}, tags);
            }).find("vertex 1"),
            std::string::npos);
  EXPECT_NE(error_of([&] { tagger.blend(tags, 1.5F, tags); }), "");
  EXPECT_EQ(tags, std::vector<float>(4, -7.0F));
}

TEST(Tagger, UpdatesAllocateNothing) {
  const testing::Mesh mesh = testing::make_torus(3, 1, 16);
  Tagger tagger(mesh.vertices(), mesh.triangles, 6);
  std::vector<float> tags(mesh.vertices());
  std::vector<float> other(mesh.vertices());
  const std::vector<float> coordinates(2 * mesh.vertices(), 0.25F);
  const std::vector<float> heights(16, 1.0F);
  const int before = glark::test::allocations();
  tagger.by_distance(mesh.positions, {}, tags);
  tagger.by_edge_length(mesh.positions, {}, 4, other);
  tagger.take_greater(other, tags);
  tagger.by_curvature(mesh.positions, mesh.normals, 0.01F, other);
  tagger.take_lesser(other, tags);
  tagger.by_displacement(coordinates, {heights, 4, 4}, 0.01F, other);
  tagger.blend(other, 0.5F, tags);
  tagger.keep_budget(2000, tags);
  EXPECT_EQ(glark::test::allocations(), before);
}

}  // namespace
}  // namespace glark::depth
