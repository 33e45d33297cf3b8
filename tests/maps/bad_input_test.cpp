// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Arguments that cannot be used, unusual ones that can, and files.
#include <glark/maps.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "tests/common/temporary_folder.h"
#include "tests/maps/bumpy_sphere.h"

namespace glark::maps::test {
namespace {

const float nan = std::numeric_limits<float>::quiet_NaN();

class BadInput : public testing::Test {
 protected:
  Baked bake_it(const BakeOptions& options = {}) const {
    return bake(coarse_, mesh_source(sphere_.fine(), 1), options);
  }
  void expect_error(Element element, std::size_t index, const BakeOptions& options = {}) const {
    try {
      bake_it(options);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.element(), element) << error.what();
      EXPECT_EQ(error.index(), index) << error.what();
    }
  }

  Sphere sphere_ = sphere_of(2, false);
  CoarseMesh coarse_ = sphere_.coarse();
};

TEST_F(BadInput, OptionsOutOfRange) {
  expect_error(Element::option, 0, {.texture_memory = 1000});
  expect_error(Element::option, 0, {.most_side = 63});
  expect_error(Element::option, 0, {.most_side = 32769});
  expect_error(Element::option, 0, {.texels_per_point = 0});
  expect_error(Element::option, 0, {.texels_per_point = static_cast<double>(nan)});
  expect_error(Element::option, 0, {.noise = -1});
  expect_error(Element::option, 0, {.reach = -1});
}

TEST_F(BadInput, ArraysThatDoNotFitTogether) {
  coarse_.positions = coarse_.positions.first(4);
  expect_error(Element::array, 0);
  coarse_ = sphere_.coarse();
  coarse_.normals = coarse_.normals.first(3);
  expect_error(Element::array, 0);
  coarse_ = sphere_.coarse();
  coarse_.triangles = coarse_.triangles.first(4);
  expect_error(Element::array, 0);
  coarse_.triangles = {};
  expect_error(Element::array, 0);
}

TEST_F(BadInput, VerticesAndTrianglesThatCannotBeUsed) {
  std::vector<float> positions = sphere_.positions;
  positions[3 * 7 + 1] = nan;
  coarse_.positions = positions;
  expect_error(Element::point, 7);
  coarse_ = sphere_.coarse();
  std::vector<std::uint32_t> triangles = sphere_.triangles;
  triangles[3 * 5 + 2] = 100000;
  coarse_.triangles = triangles;
  expect_error(Element::triangle, 5);
  const std::vector<std::uint32_t> points_only{1, 1, 1};
  coarse_.triangles = points_only;
  expect_error(Element::array, 0);
  const std::vector<float> line{0, 0, 0, 1, 0, 0, 2, 0, 0};
  const std::vector<std::uint32_t> thin{0, 1, 2};
  coarse_ = {.positions = line, .triangles = thin};
  expect_error(Element::array, 0);
}

TEST_F(BadInput, NoPointNearTheMesh) {
  std::vector<float> far = sphere_.positions;
  for (float& x : far) x *= 10;
  coarse_.positions = far;
  expect_error(Element::array, 0);
}

TEST_F(BadInput, TextureMemoryForFewerCharts) {
  Sphere dust;  // so many separate triangles that their gutters alone need more
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const std::uint32_t row = i / 200;
    const float x = static_cast<float>(i % 200), y = static_cast<float>(row);
    dust.positions.insert(dust.positions.end(), {x, y, 0, x + 0.5F, y, 0, x, y + 0.5F, 0});
    dust.triangles.insert(dust.triangles.end(), {3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_THROW(bake(dust.coarse(), mesh_source(dust.fine(), 1), {.texture_memory = std::size_t{1} << 20}), Error);
}

TEST_F(BadInput, PointsThatAreNotFinite) {
  std::vector<float> points = sphere_.positions;
  points[3 * 4] = nan;
  const FineMesh fine{.positions = points};
  try {
    bake(coarse_, mesh_source(fine, 1));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.element(), Element::point);
    EXPECT_EQ(error.index(), 4U);
  }
  const Baked model = bake(coarse_, mesh_source(fine, 1), {.skip_invalid = true});
  EXPECT_EQ(model.invalid, 1U);
  EXPECT_EQ(model.points, points.size() / 3);
}

TEST_F(BadInput, MeshSourceChecksItsArguments) {
  EXPECT_THROW(mesh_source(sphere_.fine(), 0), Error);
  EXPECT_THROW(mesh_source(sphere_.fine(), static_cast<double>(nan)), Error);
  FineMesh mesh = sphere_.fine();
  mesh.colours = mesh.colours.first(3);
  EXPECT_THROW(mesh_source(mesh, 1), Error);
  std::vector<std::uint32_t> triangles = sphere_.triangles;
  triangles[0] = 4000;
  mesh = sphere_.fine();
  mesh.triangles = triangles;
  EXPECT_THROW(mesh_source(mesh, 1), Error);
}

TEST_F(BadInput, TrianglesWithoutAreaStayInTheModel) {
  std::vector<std::uint32_t> triangles = sphere_.triangles;
  triangles.insert(triangles.end(), {0, 0, 1, 2, 2, 2});
  coarse_.triangles = triangles;
  EXPECT_EQ(bake_it().triangles.size(), triangles.size());
}

TEST(MeshSource, SamplesTrianglesEvenly) {
  const std::vector<float> positions{0, 0, 0, 3, 0, 0, 0, 4, 0};  // the longest edge has 5
  const std::vector<std::uint32_t> triangles{0, 1, 2};
  const FineMesh mesh{.positions = positions, .triangles = triangles};
  const stream::Source source = mesh_source(mesh, 1.25);  // 4 parts
  const auto reader = source.open({});
  EXPECT_EQ(reader->count(), 3U + 16U);
  const stream::Points points = reader->read(1000);
  ASSERT_EQ(points.size(), 19U);
  std::array<double, 3> centre{};
  for (std::size_t i = 3; i < 19; ++i) {
    for (std::size_t k = 0; k < 3; ++k) centre.at(k) += points.positions[3 * i + k] / 16;
    EXPECT_GT(points.positions[3 * i] / 3 + points.positions[3 * i + 1] / 4, 0);
    EXPECT_LT(points.positions[3 * i] / 3 + points.positions[3 * i + 1] / 4, 1);
    EXPECT_EQ(points.normals[3 * i + 2], 1);
  }
  EXPECT_NEAR(centre[0], 1, 1e-12);
  EXPECT_NEAR(centre[1], 4 / 3.0, 1e-12);
  EXPECT_EQ(reader->read(10).size(), 0U);
}

TEST(MeshSource, ReadsTheSamePointsAfterSeek) {
  const Sphere sphere = sphere_of(1, true);
  const stream::Source source = mesh_source(sphere.fine(), 0.2);
  const auto reader = source.open({});
  const stream::Points all = reader->read(1000000);
  const std::vector<double> positions(all.positions.begin(), all.positions.end());
  reader->seek(100);
  const stream::Points some = reader->read(7);
  EXPECT_EQ(some.first, 100U);
  EXPECT_TRUE(std::equal(some.positions.begin(), some.positions.end(), positions.begin() + 300));
  EXPECT_THROW(reader->seek(positions.size()), Error);
}

class WriteModel : public glark::test::TemporaryFolder {};

TEST_F(WriteModel, WritesTheModelAndTheDisplacementBesideIt) {
  const Sphere sphere = sphere_of(2, false);
  const Baked model = bake(sphere.coarse(), mesh_source(sphere_of(4, true).fine(), 0.1));
  const std::filesystem::path file = path("a model.glb");
  write_model(file, model);
  std::ifstream glb(file, std::ios::binary);
  std::string magic(4, '\0');
  glb.read(magic.data(), 4);
  EXPECT_EQ(magic, "glTF");
  std::ifstream png(path("a model.displacement.png"), std::ios::binary);
  std::string header(26, '\0');
  png.read(header.data(), 26);
  EXPECT_EQ(header.substr(1, 3), "PNG");
  EXPECT_EQ(header[24], 16);  // bits
  EXPECT_EQ(header[25], 0);   // grey
}

TEST_F(WriteModel, LeavesNothingWhereItCannotWrite) {
  const Sphere sphere = sphere_of(1, false);
  const Baked model = bake(sphere.coarse(), mesh_source(sphere.fine(), 0.1));
  EXPECT_THROW(write_model(path("missing") / "model.glb", model), Error);
  EXPECT_EQ(file_count(), 0U);
}

}  // namespace
}  // namespace glark::maps::test
