// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Unusual samples, and wrong arguments.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/reconstruct/meshes.h"

namespace glark::reconstruct::test {
namespace {

std::vector<float> repeated(std::size_t count, const std::vector<float>& point) {
  std::vector<float> positions;
  for (std::size_t i = 0; i < count; ++i) positions.insert(positions.end(), point.begin(), point.end());
  return positions;
}

void expect_nothing(const std::vector<float>& positions) {
  EXPECT_TRUE(reconstruct({.positions = positions}).triangles.empty());
  std::vector<float> normals(positions.size());
  EXPECT_TRUE(reconstruct({.positions = positions, .normals = normals}).triangles.empty()) << "zero normals";
  for (std::size_t i = 0; i < normals.size(); i += 3) normals[i] = 1;
  expect_manifold(reconstruct({.positions = positions, .normals = normals}));
}

TEST(BadSamples, NoneOneAndEqualOnesGiveNoTriangles) {
  expect_nothing({});
  expect_nothing({1, 2, 3});
  expect_nothing({1, 2, 3, 4, 5, 6});
  expect_nothing(repeated(1000, {1e6F, -2, 3}));
}

TEST(BadSamples, OnALineGiveAStripAtMost) {
  std::vector<float> positions;
  for (int i = 0; i < 500; ++i) {
    const auto t = static_cast<float>(i);
    positions.insert(positions.end(), {t, 2 * t, -t});
  }
  const Reconstructed mesh = reconstruct({.positions = positions});
  expect_manifold(mesh);
  const double off = greatest(mesh, [](float x, float y, float z) { return std::hypot(y - 2 * x, z + x); });
  EXPECT_LE(off, 8 * static_cast<double>(mesh.node_side));
}

TEST(BadSamples, OnAPlaneGiveAnOpenSheet) {
  std::vector<float> positions;
  for (int i = 0; i < 10000; ++i) {
    const int row = i / 100;
    positions.insert(positions.end(), {static_cast<float>(i % 100), static_cast<float>(row), 5});
  }
  const Reconstructed mesh = reconstruct({.positions = positions});
  expect_manifold(mesh);
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.parts, 1U);
  EXPECT_EQ(topology.euler, 1);
  EXPECT_LT(greatest(mesh, [](float, float, float z) { return z - 5; }), 1e-3);
}

TEST(BadSamples, AMillionDuplicatesCountOnce) {
  Shape shape = sphere(20000);
  const std::vector<float> many = repeated(1000000, {0.6F, 0.8F, 0});
  shape.positions.insert(shape.positions.end(), many.begin(), many.end());
  shape.normals.insert(shape.normals.end(), many.begin(), many.end());
  expect_closed(reconstruct(shape.points()), 1, 2);
}

TEST(BadSamples, WithoutSomeNormalsTheOthersCount) {
  Shape shape = sphere(40000);
  for (std::size_t i = 0; i < shape.normals.size(); ++i) {
    if (i / 3 % 2 == 0) shape.normals[i] = 0;
  }
  expect_closed(reconstruct(shape.points()), 1, 2);
}

TEST(BadSamples, WithoutAnyNormalsTheyAreEstimated) {
  const Shape shape = sphere(20000);
  expect_closed(reconstruct({.positions = shape.positions}), 1, 2);
}

TEST(BadSamples, ThatAreOnNoSurfaceEndInAManifold) {
  std::mt19937 random(3);
  std::vector<float> positions, normals;
  const auto number = [&] { return static_cast<float>(random()) / 2147483648.0F - 1; };
  for (int i = 0; i < 60000; ++i) positions.push_back(number());
  for (int i = 0; i < 60000; ++i) normals.push_back(number());
  for (const float samples : {2.0F, 6.0F, 50.0F})
    expect_manifold(
        reconstruct({.positions = positions, .normals = normals}, {.node_samples = samples, .least_part = 0}));
}

TEST(BadSamples, OneFarAwayLeavesTheOthersTheirSurface) {
  Shape shape = sphere(20000);
  for (const float distance : {30.0F, 1000.0F}) {
    Shape other = shape;
    other.positions.insert(other.positions.end(), {distance, 0, 0});
    other.normals.insert(other.normals.end(), {1, 0, 0});
    expect_closed(reconstruct(other.points()), 1, 2);
  }
}

TEST(BadSamples, TinyAndHugeOnesGiveTheSame) {
  for (const float scale : {1e-30F, 1e17F}) {
    Shape shape = sphere(20000);
    for (float& number : shape.positions) number *= scale;
    expect_closed(reconstruct(shape.points()), 1, 2);
  }
}

template <typename Work>
void expect_error(Element element, const std::string& words, Work&& work) {
  try {
    work();
    ADD_FAILURE() << "no error about " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.element(), element) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(BadSamples, ThatAreNotFiniteAreErrors) {
  for (const float wrong : {std::nanf(""), std::numeric_limits<float>::infinity(), 1e30F}) {
    Shape shape = sphere(100);
    shape.positions[22] = wrong;
    expect_error(Element::point, "point 7 ", [&] { reconstruct(shape.points()); });
  }
  Shape shape = sphere(100);
  shape.normals[13] = std::nanf("");
  expect_error(Element::point, "make it zero", [&] { reconstruct(shape.points()); });
  shape.normals[13] = 0;
  shape.colours.resize(9);
  expect_error(Element::array, "colours", [&] {
    reconstruct({.positions = shape.positions, .normals = shape.normals, .colours = shape.colours});
  });
  shape.normals.resize(9);
  expect_error(Element::array, "normals", [&] { reconstruct(shape.points()); });
}

TEST(BadSamples, OptionsAreInRange) {
  const Shape shape = sphere(100);
  const auto with = [&](const ReconstructOptions& options) { reconstruct(shape.points(), options); };
  expect_error(Element::option, "threshold", [&] { with({.threshold = -1}); });
  expect_error(Element::option, "error", [&] { with({.error = std::nanf("")}); });
  expect_error(Element::option, "levels", [&] { with({.levels = 7}); });
  expect_error(Element::option, "node_samples", [&] { with({.node_samples = 1}); });
  expect_error(Element::option, "delta_a", [&] { with({.delta_a = 2}); });
  expect_error(Element::option, "least_part", [&] { with({.least_part = 1.5F}); });
  expect_error(Element::option, "gap_edges", [&] { with({.gap_edges = 5000}); });
}

}  // namespace
}  // namespace glark::reconstruct::test
