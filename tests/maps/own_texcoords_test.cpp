// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Models that keep the texture coordinates of the coarse mesh.
#include <glark/maps.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "glark/clients/maps/atlas/atlas.h"
#include "glark/clients/maps/charts/islands.h"
#include "tests/maps/bumpy_errors.h"
#include "tests/maps/bumpy_sphere.h"
#include "tests/maps/own_meshes.h"

namespace glark::maps::test {
namespace {

Baked bake_bumps_onto(const OwnMesh& mesh, const BakeOptions& options = {}) {
  const Sphere fine = sphere_of(6, true);
  return bake(mesh.coarse(), mesh_source(fine.fine(), 0.02), options);
}

TEST(OwnTexcoords, StayWithTheVerticesInTheirOrder) {
  const OwnMesh mesh = cube_sphere(6);
  const Baked model = bake_bumps_onto(mesh);
  EXPECT_TRUE(model.has_own_texcoords);
  EXPECT_EQ(model.texcoords_fault, "");
  EXPECT_EQ(model.charts, 6U);
  EXPECT_EQ(model.triangles, mesh.triangles);
  EXPECT_EQ(model.positions, mesh.positions);
  ASSERT_EQ(model.texcoords.size(), mesh.texcoords.size());
  for (std::size_t i = 0; i < mesh.texcoords.size(); i += 2) {
    EXPECT_EQ(model.texcoords[i], mesh.texcoords[i]);
    EXPECT_EQ(model.texcoords[i + 1], 1 - mesh.texcoords[i + 1]);
  }
}

class OwnLayouts : public testing::TestWithParam<Layout> {};

TEST_P(OwnLayouts, DisplacedSurfaceIsTheFineOne) {
  const Errors errors = errors_of(bake_bumps_onto(cube_sphere(8, GetParam())));
  EXPECT_LT(errors.distance, 0.002);  // bumps are 0.05 high
  EXPECT_LT(errors.degrees, 5);
  EXPECT_LT(std::sqrt(errors.degrees_squared), 0.6);
  EXPECT_LT(errors.colour, 0.03);
}

TEST_P(OwnLayouts, SeamsAgree) {
  const Baked model = bake_bumps_onto(cube_sphere(8, GetParam()));
  EXPECT_EQ(model.seams.edges, 12U * 8);
  EXPECT_LE(model.seams.colour.greatest, 2.0F / 255);
  EXPECT_LE(model.seams.normal.greatest, 1);
  EXPECT_LE(model.seams.displacement.greatest, model.scale / 2000);
  for (const SeamJumps& jumps : model.mip_seams) {
    EXPECT_LE(jumps.colour.root_mean_square, 1.0F / 255);
    EXPECT_LE(jumps.normal.root_mean_square, 1);
  }
}

// The fourth number of a tangent is the side to which the texture turns.
TEST_P(OwnLayouts, TangentsFollowTheTexture) {
  const OwnMesh mesh = cube_sphere(5, GetParam());
  const Baked model = bake_bumps_onto(mesh);
  const auto vector = [](const std::vector<float>& values, std::size_t width, std::size_t i) {
    return common::Vector3f{values[width * i], values[width * i + 1], values[width * i + 2]};
  };
  bool has_mirrored = false;
  for (std::size_t t = 0; t < model.triangles.size(); t += 3) {
    const std::size_t a = model.triangles[t], b = model.triangles[t + 1], c = model.triangles[t + 2];
    const auto along = [&](std::size_t vertex, std::size_t axis) {
      return model.texcoords[2 * vertex + axis] - model.texcoords[2 * a + axis];
    };
    const float area = along(b, 0) * along(c, 1) - along(c, 0) * along(b, 1);
    const auto edge = vector(model.positions, 3, b) - vector(model.positions, 3, a);
    const auto other = vector(model.positions, 3, c) - vector(model.positions, 3, a);
    const auto along_s = common::unit((edge * along(c, 1) - other * along(b, 1)) * (1 / area));
    EXPECT_GT(common::dot(along_s, vector(model.tangents, 4, a)), 0.8F);
    EXPECT_EQ(model.tangents[4 * a + 3], area < 0 ? 1 : -1);
    has_mirrored = has_mirrored || area > 0;
  }
  EXPECT_EQ(has_mirrored, GetParam() == Layout::mirrored);
}

TEST_P(OwnLayouts, MissingNormalsComeFromTheDisplacedSurface) {
  const Sphere fine = sphere_of(7, true);
  const Baked model = bake(cube_sphere(8, GetParam()).coarse(), mesh_source({.positions = fine.positions}, 1));
  const Errors errors = errors_of(model);
  EXPECT_LT(errors.distance, 0.003);
  EXPECT_LT(std::sqrt(errors.degrees_squared), 4);
}

// Texels of mirrored islands have their second axis turned: so the normals in object space are those of the surface.
TEST_P(OwnLayouts, NormalsInObjectSpace) {
  const Baked model = bake_bumps_onto(cube_sphere(8, GetParam()));
  const std::vector<std::uint8_t> map = object_normals(model);
  const SeenModel seen_model(model);
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t) {
    std::array<double, 2> at{};
    for (std::size_t k = 0; k < 6; ++k)
      at.at(k % 2) += static_cast<double>(model.texcoords[2 * std::size_t{model.triangles[3 * t + k / 2]} + k % 2]) / 3;
    const auto x = static_cast<std::size_t>(at[0] * model.width), y = static_cast<std::size_t>(at[1] * model.height);
    const std::uint8_t* const texel = &map[3 * (y * model.width + x)];
    const Precise normal = common::unit(Precise{texel[0] - 127.5, texel[1] - 127.5, texel[2] - 127.5});
    const Precise direction = common::unit(seen_model.at(t, {1 / 3.0, 1 / 3.0, 1 / 3.0}).position);
    EXPECT_GT(common::dot(normal, bumpy_normal(direction)), 0.997) << "triangle " << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Layouts, OwnLayouts, testing::Values(Layout::plain, Layout::mirrored),
                         [](const auto& layout) { return layout.param == Layout::plain ? "Plain" : "Mirrored"; });

TEST(OwnTexcoords, AnIslandThatMeetsItselfHasASeamThere) {
  const OwnMesh mesh = globe(32, 12);
  const Baked model = bake_bumps_onto(mesh);
  EXPECT_EQ(model.charts, 1U);
  EXPECT_EQ(model.seams.edges, 12U);
  EXPECT_LE(model.seams.normal.greatest, 1);
  EXPECT_LE(model.seams.colour.greatest, 2.0F / 255);
  EXPECT_EQ(model.triangles, mesh.triangles);
  EXPECT_LT(errors_of(model).distance, 0.005);  // as with charts: at the borders, points lie beyond the mesh
}

// Islands are less than three texels apart.
TEST(OwnTexcoords, IslandsMayBeNearToEachOther) {
  const Baked model = bake_bumps_onto(cube_sphere(8, Layout::plain, 0.008), {.width = 512, .height = 512});
  EXPECT_LE(model.seams.normal.greatest, 1);
  EXPECT_LE(model.seams.displacement.greatest, model.scale / 1000);
  EXPECT_LT(errors_of(model).distance, 0.003);
}

TEST(OwnTexcoords, SizeIsThatOfTheOptions) {
  const Baked model = bake_bumps_onto(cube_sphere(6), {.width = 256, .height = 128});
  EXPECT_EQ(model.width, 256U);
  EXPECT_EQ(model.height, 128U);
  EXPECT_LT(errors_of(model).distance, 0.006);
  const Baked charts = bake_bumps_onto(cube_sphere(6), {.width = 256, .height = 512, .texcoords = Texcoords::charts});
  EXPECT_EQ(charts.width, 256U);
  EXPECT_EQ(charts.height, 512U);
  EXPECT_FALSE(charts.has_own_texcoords);
  EXPECT_EQ(charts.texcoords_fault, "");
  EXPECT_GT(charts.texels, 256U * 512 / 2);  // the charts fill the maps
}

// A face is a third of the width and half of the height: so the maps are twice as wide as high.
TEST(OwnTexcoords, TexelsAreAboutSquareOnTheSurface) {
  const Baked model = bake_bumps_onto(cube_sphere(6));
  EXPECT_EQ(model.width, 2 * model.height);
  const double texels = double(model.width) * model.height * 0.81;
  const double wanted = 2.0 * static_cast<double>(model.points);
  EXPECT_GT(texels, 0.45 * wanted);
  EXPECT_LT(texels, 2.2 * wanted);
  EXPECT_EQ(model.density, 1);
}

TEST(OwnTexcoords, LimitsHold) {
  const Baked small = bake_bumps_onto(cube_sphere(6), {.texture_memory = std::size_t{1} << 20});
  EXPECT_LE(std::size_t{small.width} * small.height * 8 * 4 / 3, std::size_t{1} << 20);
  EXPECT_LT(small.density, 0.7);
  EXPECT_LE(bake_bumps_onto(cube_sphere(6), {.most_side = 128}).width, 128U);
  EXPECT_LT(bake_bumps_onto(cube_sphere(6), {.noise = 0.01}).width, bake_bumps_onto(cube_sphere(6)).width);
}

TEST(OwnTexcoords, ResultDoesNotDependOnThreads) {
  const OwnMesh mesh = cube_sphere(6, Layout::mirrored);
  const Baked one = bake_bumps_onto(mesh, {.threads = 1}), two = bake_bumps_onto(mesh, {.threads = 2});
  EXPECT_EQ(one.normal_map, two.normal_map);
  EXPECT_EQ(one.colour_map, two.colour_map);
  EXPECT_EQ(one.displacement_map, two.displacement_map);
}

// Rings within rings: their rectangles overlap, but they do not.
TEST(OwnTexcoords, RingsWithinRingsTakeNoMoreMemory) {
  OwnMesh mesh;
  constexpr std::uint32_t rings = 30, parts = 48;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const std::uint32_t first = mesh.vertices();
    for (std::uint32_t side = 0; side < 2; ++side)
      for (std::uint32_t i = 0; i <= parts; ++i) {
        const double turn = -2 * std::numbers::pi * (i % parts) / parts, radius = ring + 1 + side;
        const double in_texture = (ring + 1 + 0.3 * side) / (rings + 2) / 2;
        mesh.add_vertex({radius * std::cos(turn), radius * std::sin(turn), 0}, 0.5 + in_texture * std::cos(turn),
                        0.5 + in_texture * std::sin(turn));
      }
    mesh.add_grid(first, parts + 1, 2);
  }
  const CoarseMesh coarse = mesh.coarse();
  const Baked model = bake(coarse, mesh_source({.positions = mesh.positions, .triangles = mesh.triangles}, 0.1),
                           {.width = 1024, .height = 1024});
  EXPECT_EQ(model.charts, rings);
  EXPECT_EQ(model.triangles, mesh.triangles);
  EXPECT_LE(model.texels, 1024U * 1024);
  EXPECT_LE(model.seams.normal.greatest, 1);
}

// Two triangles share a vertex and its texture coordinates, but one of them is mirrored.
TEST(OwnTexcoords, AVertexWithTwoTangentsIsThereTwice) {
  OwnMesh mesh;
  mesh.add_vertex({0, 0, 0}, 0.5, 0.5);
  mesh.add_vertex({1, 0, 0}, 0.9, 0.5);
  mesh.add_vertex({0, 1, 0}, 0.5, 0.9);
  mesh.add_vertex({-1, 0, 0}, 0.1, 0.5);
  mesh.add_vertex({0, -1, 0}, 0.1, 0.9);
  mesh.triangles = {0, 1, 2, 0, 3, 4};
  const Baked model = bake(mesh.coarse(), mesh_source({.positions = mesh.positions, .triangles = mesh.triangles}, 0.05),
                           {.texcoords = Texcoords::own});
  EXPECT_EQ(model.charts, 2U);
  EXPECT_GE(model.positions.size() / 3, 5U);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) EXPECT_EQ(model.positions[i], mesh.positions[i]);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(model.tangents[4 * model.triangles[k] + 3], k < 3 ? 1 : -1);
}

class Faults : public testing::Test {
 protected:
  void expect_fault(const std::string& part) const {
    try {
      bake_onto(Texcoords::own);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.element(), Element::array);
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    const Baked model = bake_onto(Texcoords::automatic);
    EXPECT_FALSE(model.has_own_texcoords);
    EXPECT_NE(model.texcoords_fault.find(part), std::string::npos) << model.texcoords_fault;
    EXPECT_TRUE(bake_onto(Texcoords::charts).texcoords_fault.empty());
  }
  Baked bake_onto(Texcoords texcoords) const {
    const Sphere fine = sphere_of(4, false);
    return bake(mesh_.coarse(), mesh_source(fine.fine(), 0.05), {.texcoords = texcoords});
  }
  float& texcoord(std::uint32_t vertex, std::size_t axis) { return mesh_.texcoords[2 * std::size_t{vertex} + axis]; }

  OwnMesh mesh_ = cube_sphere(4);
  static constexpr std::uint32_t vertices_of_face = 25;
};

TEST_F(Faults, NoCoordinates) {
  mesh_.texcoords.clear();
  expect_fault("it has no texture coordinates");
}

TEST_F(Faults, NotFinite) {
  texcoord(7, 1) = std::numeric_limits<float>::quiet_NaN();
  expect_fault("is not a finite number");
}

TEST_F(Faults, TilesBeyondOne) {
  for (std::uint32_t i = 0; i < vertices_of_face; ++i) texcoord(i, 0) += 1;
  expect_fault("go from 0 to 1.32, beyond 0 to 1");
}

TEST_F(Faults, TwoFacesOnOnePlace) {
  for (std::uint32_t i = 0; i < vertices_of_face; ++i) texcoord(i + vertices_of_face, 0) = texcoord(i, 0);
  expect_fault("16.7 % of the area of its texture coordinates lies on other parts of them");
}

TEST_F(Faults, AFaceWithoutArea) {
  for (std::uint32_t i = 0; i < vertices_of_face; ++i) texcoord(i, 0) = 0;
  expect_fault("of its surface has texture coordinates without an area");
}

TEST_F(Faults, OfRoundingDoNotCount) {
  for (std::uint32_t i = 0; i < vertices_of_face; ++i) texcoord(i, 0) -= texcoord(0, 0) + 5e-5F;
  EXPECT_TRUE(bake_onto(Texcoords::own).has_own_texcoords);
}

TEST_F(Faults, ArraysThatDoNotFitTogether) {
  mesh_.texcoords.pop_back();
  EXPECT_THROW(bake_onto(Texcoords::charts), Error);
}

TEST_F(Faults, SizesThatAreNoPowersOfTwo) {
  const Sphere fine = sphere_of(3, false);
  for (const std::array<unsigned, 2> size : {std::array{100U, 128U}, {128U, 0U}, {32U, 64U}, {65536U, 64U}})
    EXPECT_THROW(bake(mesh_.coarse(), mesh_source(fine.fine(), 0.1), {.width = size[0], .height = size[1]}), Error);
}

}  // namespace
}  // namespace glark::maps::test
