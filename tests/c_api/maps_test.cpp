// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <glark/c/maps.h>
#include <glark/maps.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/c_api/shapes.h"
#include "tests/common/temporary_folder.h"

namespace glark::test {
namespace {

// An octahedron within a sphere of points, small maps.
class MapsInC : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    options_.texture_memory = std::size_t{1} << 20;
    cpp_options_.texture_memory = options_.texture_memory;
  }
  std::string file(const char* name) const { return path(name).string(); }
  std::string scan() const {
    made("scan.raw", {reinterpret_cast<const char*>(points_.data()), points_.size() * sizeof(float)});
    return file("scan.raw");
  }

  const std::vector<float> points_ = sphere(3000);
  const std::vector<std::uint8_t> colours_ = std::vector<std::uint8_t>(points_.size(), 90);
  const glark_maps_coarse_mesh mesh_{{1, 0, 0}, array(octahedron), {}, array(octahedron_triangles), {}};
  const glark_maps_fine_mesh fine_{{1, 0, 0}, array(points_), array(points_), {colours_.data(), colours_.size()}, {}};
  const maps::CoarseMesh cpp_mesh_{
      .origin = {1, 0, 0}, .positions = octahedron, .normals = {}, .triangles = octahedron_triangles};
  glark_maps_options options_ = glark_maps_default_options();
  maps::BakeOptions cpp_options_;
  glark_maps_model* model_ = nullptr;
  glark_error error_{};
};

void expect_same(const maps::Jump& jump, const glark_maps_jump& in_c) {
  EXPECT_EQ(jump.greatest, in_c.greatest);
  EXPECT_EQ(jump.root_mean_square, in_c.root_mean_square);
}

TEST_F(MapsInC, TheModelIsThatOfCpp) {
  ASSERT_EQ(GLARK_SUCCESS, glark_maps_bake_mesh(&mesh_, &fine_, 1, &options_, &model_, &error_)) << error_.message;
  const maps::FineMesh fine{
      .origin = {1, 0, 0}, .positions = points_, .normals = points_, .colours = colours_, .triangles = {}};
  const maps::Baked same = maps::bake(cpp_mesh_, maps::mesh_source(fine, 1), cpp_options_);
  EXPECT_EQ(same.positions, copy(glark_maps_positions(model_)));
  EXPECT_EQ(same.normals, copy(glark_maps_normals(model_)));
  EXPECT_EQ(same.tangents, copy(glark_maps_tangents(model_)));
  EXPECT_EQ(same.texcoords, copy(glark_maps_texcoords(model_)));
  EXPECT_EQ(same.triangles, copy(glark_maps_triangles(model_)));
  EXPECT_EQ(octahedron_triangles.size(), same.triangles.size());
  EXPECT_EQ(same.normal_map, copy(glark_maps_normal_map(model_)));
  EXPECT_EQ(same.colour_map, copy(glark_maps_colour_map(model_)));
  EXPECT_FALSE(same.colour_map.empty());
  const glark_maps_heights heights = glark_maps_displacement_map(model_);
  EXPECT_EQ(same.displacement_map, std::vector<std::uint16_t>(heights.data, heights.data + heights.count));
  glark_maps_model_free(model_);
}

TEST_F(MapsInC, NumbersAreThoseOfCpp) {
  ASSERT_EQ(GLARK_SUCCESS, glark_maps_bake_file(&mesh_, scan().c_str(), "raw", &options_, &model_, &error_))
      << error_.message;
  const maps::Baked same = maps::bake(cpp_mesh_, stream::file_source(scan()), cpp_options_);
  const glark_maps_frame frame = glark_maps_model_frame(model_);
  EXPECT_EQ(1, frame.origin[0]);
  EXPECT_EQ(same.width, frame.width);
  EXPECT_EQ(same.height, frame.height);
  EXPECT_EQ(same.scale, frame.scale);
  EXPECT_EQ(same.bias, frame.bias);
  const glark_maps_counts counts = glark_maps_model_counts(model_);
  EXPECT_EQ(3000u, counts.points);
  EXPECT_EQ(same.left_out, counts.left_out);
  EXPECT_EQ(same.charts, counts.charts);
  EXPECT_EQ(same.texels, counts.texels);
  EXPECT_EQ(same.filled, counts.filled);
  EXPECT_EQ(same.reach, counts.reach);
  const glark_maps_seams seams = glark_maps_model_seams(model_);
  EXPECT_EQ(same.seams.edges, seams.edges);
  expect_same(same.seams.normal, seams.normal);
  expect_same(same.seams.displacement, seams.displacement);
  EXPECT_EQ(0u, glark_maps_colour_map(model_).count);  // a .raw file has no colours
  glark_maps_model_free(model_);
}

// Each triangle of the octahedron has its own corner of the texture.
TEST_F(MapsInC, TextureCoordinatesOfTheMeshAreKept) {
  std::vector<float> positions, texcoords;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < octahedron_triangles.size(); ++i) {
    const float* const p = &octahedron[3 * std::size_t{octahedron_triangles[i]}];
    positions.insert(positions.end(), {p[0], p[1], p[2]});
    const std::uint32_t t = i / 3, row = t / 4;
    texcoords.push_back((static_cast<float>(t % 4) + (i % 3 == 1 ? 0.9F : 0.2F)) / 4);
    texcoords.push_back((static_cast<float>(row) + (i % 3 == 2 ? 0.9F : 0.2F)) / 2);
    triangles.push_back(i);
  }
  const glark_maps_coarse_mesh mesh{{1, 0, 0}, array(positions), {}, array(triangles), array(texcoords)};
  options_.width = 128;
  options_.height = 64;
  options_.texcoords = GLARK_MAPS_TEXCOORDS_OWN;
  ASSERT_EQ(GLARK_SUCCESS, glark_maps_bake_mesh(&mesh, &fine_, 1, &options_, &model_, &error_)) << error_.message;
  EXPECT_TRUE(glark_maps_has_own_texcoords(model_));
  EXPECT_EQ(triangles, copy(glark_maps_triangles(model_)));
  EXPECT_EQ(texcoords[0], glark_maps_texcoords(model_).data[0]);
  EXPECT_EQ(128u, glark_maps_model_frame(model_).width);
  EXPECT_EQ(64u, glark_maps_model_frame(model_).height);
  glark_maps_model_free(model_);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_mesh(&mesh_, &fine_, 1, &options_, &model_, &error_));
  EXPECT_EQ(GLARK_MAPS_ARRAY, error_.element);
  EXPECT_TRUE(contains(error_, "it has no texture coordinates")) << error_.message;
  options_.texcoords = GLARK_MAPS_TEXCOORDS_AUTOMATIC;
  ASSERT_EQ(GLARK_SUCCESS, glark_maps_bake_mesh(&mesh_, &fine_, 1, &options_, &model_, &error_)) << error_.message;
  EXPECT_FALSE(glark_maps_has_own_texcoords(model_));
  glark_maps_model_free(model_);
}

TEST_F(MapsInC, WritesBothFiles) {
  ASSERT_EQ(GLARK_SUCCESS, glark_maps_bake_mesh(&mesh_, &fine_, 1, &options_, &model_, &error_)) << error_.message;
  EXPECT_EQ(GLARK_SUCCESS, glark_maps_write_model(file("a.glb").c_str(), model_, &error_)) << error_.message;
  EXPECT_GT(std::filesystem::file_size(path("a.glb")), 1000u);
  EXPECT_GT(std::filesystem::file_size(path("a.displacement.png")), 100u);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_write_model(file("none/a.glb").c_str(), model_, &error_));
  EXPECT_EQ(GLARK_MAPS_FILE, error_.element) << error_.message;
  glark_maps_model_free(model_);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_write_model(file("a.glb").c_str(), nullptr, &error_));
  EXPECT_STREQ("glark: the argument model is NULL; pass its address", error_.message);
}

TEST_F(MapsInC, ErrorsNameTheElement) {
  options_.reach = -1;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_mesh(&mesh_, &fine_, 1, &options_, &model_, &error_));
  EXPECT_EQ(GLARK_MAPS_OPTION, error_.element);
  EXPECT_TRUE(contains(error_, "glark-maps: the option reach is -1")) << error_.message;
  std::vector<std::uint32_t> triangles = octahedron_triangles;
  triangles[3 * 5] = 99;
  const glark_maps_coarse_mesh wrong{{}, array(octahedron), {}, array(triangles), {}};
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_mesh(&wrong, &fine_, 1, nullptr, &model_, &error_));
  EXPECT_EQ(GLARK_MAPS_TRIANGLE, error_.element) << error_.message;
  EXPECT_EQ(5u, error_.index);
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_mesh(&mesh_, &fine_, 0, nullptr, &model_, &error_));
  EXPECT_EQ(GLARK_MAPS_OPTION, error_.element) << error_.message;
  EXPECT_EQ(nullptr, model_);
}

TEST_F(MapsInC, ErrorsOfTheSourceNameItsFileOrPoint) {
  EXPECT_EQ(GLARK_BAD_ARGUMENT,
            glark_maps_bake_file(&mesh_, file("none.ply").c_str(), nullptr, nullptr, &model_, &error_));
  EXPECT_EQ(GLARK_MAPS_FILE, error_.element) << error_.message;
  std::vector<float> points = points_;
  points[3 * 42] = NAN;
  made("bad.raw", {reinterpret_cast<const char*>(points.data()), points.size() * sizeof(float)});
  EXPECT_EQ(GLARK_BAD_ARGUMENT,
            glark_maps_bake_file(&mesh_, file("bad.raw").c_str(), nullptr, nullptr, &model_, &error_));
  EXPECT_EQ(GLARK_MAPS_POINT, error_.element) << error_.message;
  EXPECT_EQ(42u, error_.index);
  options_.skip_invalid = true;
  ASSERT_EQ(GLARK_SUCCESS, glark_maps_bake_file(&mesh_, file("bad.raw").c_str(), nullptr, &options_, &model_, &error_))
      << error_.message;
  EXPECT_EQ(1u, glark_maps_model_counts(model_).invalid);
  glark_maps_model_free(model_);
}

TEST_F(MapsInC, NullArgumentsAreNamed) {
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_file(nullptr, "a.ply", nullptr, nullptr, &model_, &error_));
  EXPECT_TRUE(contains(error_, "the argument mesh is NULL")) << error_.message;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_file(&mesh_, nullptr, nullptr, nullptr, &model_, &error_));
  EXPECT_TRUE(contains(error_, "the argument file is NULL")) << error_.message;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_mesh(&mesh_, nullptr, 1, nullptr, &model_, &error_));
  EXPECT_TRUE(contains(error_, "the argument fine is NULL")) << error_.message;
  EXPECT_EQ(GLARK_BAD_ARGUMENT, glark_maps_bake_mesh(&mesh_, &fine_, 1, nullptr, nullptr, &error_));
  EXPECT_TRUE(contains(error_, "the argument model is NULL")) << error_.message;
}

}  // namespace

TEST(MapsNullInC, ANullModelHasNothing) {
  EXPECT_EQ(0u, glark_maps_positions(nullptr).count);
  EXPECT_EQ(0u, glark_maps_triangles(nullptr).count);
  EXPECT_EQ(0u, glark_maps_normal_map(nullptr).count);
  EXPECT_EQ(0u, glark_maps_displacement_map(nullptr).count);
  EXPECT_EQ(0u, glark_maps_model_frame(nullptr).width);
  EXPECT_EQ(0u, glark_maps_model_counts(nullptr).charts);
  EXPECT_EQ(0u, glark_maps_model_seams(nullptr).edges);
  EXPECT_FALSE(glark_maps_has_own_texcoords(nullptr));
  glark_maps_model_free(nullptr);
}

}  // namespace glark::test
