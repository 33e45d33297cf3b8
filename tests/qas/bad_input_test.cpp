// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Unusual meshes, and wrong arguments.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

// Expects finite positions and unit normals for every patch.
void expect_sound(const ControlMesh& mesh) {
  for (const unsigned which : {0U, 1U, 2U, 3U}) {
    const unsigned splits = which % 2;
    const Scheme scheme = which < 2 ? Scheme::loop : Scheme::modified_butterfly;
    Surface surface(mesh.view(), {.scheme = scheme, .splits = splits, .threads = 1});
    surface.update(mesh.positions);
    std::vector<Corner> corners(surface.corner_count());
    surface.write_corners(corners);
    ASSERT_EQ(corners.size(), mesh.triangles.size() << (2 * splits));
    for (const Corner& corner : corners) {
      for (const auto& point : {corner.position, corner.edge_position}) {
        ASSERT_TRUE(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2])) << mesh.name;
      }
      for (const auto& normal : {corner.normal, corner.edge_normal})
        ASSERT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-5) << mesh.name;
    }
  }
}

const ControlMesh triangle{"triangle", {0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}};

template <typename Work>
void expect_error(Element element, std::size_t index, const std::string& words, Work&& work) {
  try {
    work();
    ADD_FAILURE() << "no error about " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.element(), element) << error.what();
    EXPECT_EQ(error.index(), index) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(BadMesh, AnEmptyOneGivesNothing) {
  Surface surface(Mesh{});
  surface.update({});
  surface.write_corners({});
  EXPECT_EQ(surface.corner_count(), 0U);
}

TEST(BadMesh, AnIsolatedVertexIsItsOwnLimit) {
  ControlMesh mesh = triangle;
  mesh.positions.insert(mesh.positions.end(), {7, 8, 9});
  expect_sound(mesh);
  Surface surface(mesh.view());
  surface.update(mesh.positions);
  EXPECT_EQ(surface.limit_positions()[3].y, 8);
}

TEST(BadMesh, ADegenerateTriangleIsAPoint) {
  ControlMesh mesh = triangle;
  mesh.triangles.insert(mesh.triangles.end(), {1, 1, 2, 2, 2, 2});
  expect_sound(mesh);
  Surface with(mesh.view()), without(triangle.view());
  with.update(mesh.positions);
  without.update(mesh.positions);
  EXPECT_EQ(with.limit_positions()[1].x, without.limit_positions()[1].x);
  EXPECT_EQ(with.evaluate(1, {0.5F, 0.25F, 0.25F}).position, with.evaluate(1, {1, 0, 0}).position);
}

TEST(BadMesh, ARepeatedTriangleIsDrawnAsTheFirst) {
  ControlMesh mesh = triangle;
  mesh.triangles.insert(mesh.triangles.end(), {1, 2, 0, 0, 2, 1});
  expect_sound(mesh);
  Surface surface(mesh.view());
  surface.update(mesh.positions);
  const Sample first = surface.evaluate(0, {0.5F, 0.25F, 0.25F});
  const Sample turned = surface.evaluate(1, {0.25F, 0.25F, 0.5F});
  const Sample reversed = surface.evaluate(2, {0.5F, 0.25F, 0.25F});
  EXPECT_EQ(first.normal[2], 1);
  EXPECT_EQ(first.position, turned.position);
  EXPECT_EQ(first.position, reversed.position);
  EXPECT_EQ(reversed.normal[2], -1);
}

TEST(BadMesh, ANonManifoldEdgeIsACrease) {
  const ControlMesh mesh{
      "fins", {0, 0, 0, 0, 0, 1, 1, 0, 0, -1, 1, 0, -1, -1, 0}, {0, 1, 2, 0, 1, 3, 0, 1, 4, 4, 1, 0}};
  expect_sound(mesh);
  Surface surface(mesh.view());
  surface.update(mesh.positions);
  const Sample middle = surface.evaluate(0, {0.5F, 0.5F, 0});
  EXPECT_EQ(middle.position, surface.evaluate(1, {0.5F, 0.5F, 0}).position);
  EXPECT_NE(middle.normal, surface.evaluate(1, {0.5F, 0.5F, 0}).normal);
}

TEST(BadMesh, TwoFansThatMeetAtAVertexLeaveItWhereItIs) {
  const ControlMesh mesh{"bow", {0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0}, {0, 1, 2, 0, 3, 4}};
  expect_sound(mesh);
  Surface surface(mesh.view());
  surface.update(mesh.positions);
  EXPECT_EQ(surface.limit_positions()[0].x, 0);
}

TEST(BadMesh, WithoutNormalsHasThatOfItsTrianglesOrZ) {
  ControlMesh mesh = bipyramid(5);
  mesh.positions.assign(mesh.positions.size(), 3);
  expect_sound(mesh);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) mesh.positions[3 * v] = static_cast<float>(v);  // on a line
  expect_sound(mesh);
}

TEST(BadMesh, OfAnyValenceAndScale) {
  for (const int valence : {3, 4, 5, 6, 7, 20, 100, 500}) {
    for (const float scale : {1e-30F, 1e-6F, 1.0F, 1e30F}) {
      ControlMesh mesh = bipyramid(valence);
      for (float& value : mesh.positions) value *= scale;
      expect_sound(mesh);
    }
  }
}

TEST(BadMesh, OfRandomTriangles) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    ControlMesh mesh{"random", {}, {}};
    const std::size_t vertices = 3 + random() % 12;
    for (std::size_t j = 0; j < 3 * vertices; ++j) mesh.positions.push_back(static_cast<float>(random() % 5));
    for (std::size_t j = 0; j < 3 * (random() % 40); ++j)
      mesh.triangles.push_back(static_cast<std::uint32_t>(random() % vertices));
    mesh.triangles.resize(mesh.triangles.size() / 3 * 3);
    if (!mesh.triangles.empty() && mesh.triangles[0] != mesh.triangles[1] && mesh.triangles[1] != mesh.triangles[2] &&
        mesh.triangles[0] != mesh.triangles[2]) {
      mesh.creases = {mesh.triangles[0], mesh.triangles[1]};
    }
    expect_sound(mesh);
  }
}

TEST(BadArguments, NameTheTriangle) {
  const std::vector<std::uint32_t> beyond = {0, 1, 2, 0, 2, 3}, unfinished = {0, 1, 2, 0, 1};
  expect_error(Element::triangle, 1, "vertex 3 of 3", [&] { Surface surface({3, beyond}); });
  expect_error(Element::triangle, 1, "2 indices", [&] { Surface surface({3, unfinished}); });
}

TEST(BadArguments, NameTheCrease) {
  ControlMesh mesh = triangle;
  mesh.positions.resize(12);
  mesh.creases = {0, 1, 1, 3};
  expect_error(Element::crease, 1, "from vertex 1 to 3", [&] { Surface surface(mesh.view()); });
  mesh.creases = {0, 1, 1};
  expect_error(Element::crease, 1, "one end", [&] { Surface surface(mesh.view()); });
}

TEST(BadArguments, NameTheVertexAndChangeNothing) {
  Surface surface(triangle.view());
  surface.update(triangle.positions);
  const float before = surface.limit_positions()[1].x;
  for (const float wrong : {std::nanf(""), std::numeric_limits<float>::infinity(), -2e37F}) {
    for (std::size_t i = 0; i < 9; ++i) {
      std::vector<float> positions = {5, 5, 5, 5, 5, 5, 5, 5, 5};
      positions[i] = wrong;
      expect_error(Element::vertex, i / 3, std::string("the ") + "xyz"[i % 3], [&] { surface.update(positions); });
    }
  }
  EXPECT_EQ(surface.limit_positions()[1].x, before);
  expect_error(Element::array, 0, "6 values; 3 vertices take 9",
               [&] { surface.update(std::span(triangle.positions).first(6)); });
  EXPECT_EQ(surface.limit_positions()[1].x, before);
}

TEST(BadArguments, WriteNothing) {
  const Surface surface(triangle.view());
  std::vector<Corner> corners(4, Corner{{7, 7, 7}, {}, {}, {}});
  expect_error(Element::array, 0, "has 4; 1 patches have 3", [&] { surface.write_corners(corners); });
  EXPECT_EQ(corners[0].position[0], 7);
  expect_error(Element::triangle, 1, "not one of the 1", [&] { static_cast<void>(surface.evaluate(1, {1, 0, 0})); });
  for (const std::array<float, 3> wrong :
       {std::array<float, 3>{1, 1, 0}, {-1, 1, 1}, {std::nanf(""), 0, 1}, {1e30F, 0, 0}})
    expect_error(Element::array, 0, "of sum 1", [&] { static_cast<void>(surface.evaluate(0, wrong)); });
  expect_error(Element::mesh, 0, "2 times", [&] { Surface twice(triangle.view(), {.splits = 2}); });
}

}  // namespace
}  // namespace glark::qas::test
