// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Unusual points, and wrong arguments.
#include <gtest/gtest.h>

#include <limits>

#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

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

// Expects a tree with every sample in a leaf, with normals and without. Expects a simplification to at most `target`
// finite points.
void expect_sound(const std::vector<float>& positions, std::size_t target = 4) {
  const PointSet points{.positions = positions};
  for (const bool surface : {true, false}) {
    const Tree tree(points, {.surface = surface});
    std::size_t samples = 0;
    for (const Node& node : tree.nodes()) {
      samples += node.is_leaf() ? node.size() : 0;
      EXPECT_TRUE(std::isfinite(node.error));
    }
    EXPECT_EQ(samples, positions.size() / 3);
  }
  for (const Clustering clustering : {Clustering::volume_surface, Clustering::octree, Clustering::grid}) {
    const Simplified few = simplify({points}, {.clustering = clustering, .target = target});
    EXPECT_LE(few.positions.size() / 3, target);
    EXPECT_EQ(few.positions.empty(), positions.empty());
    for (const float number : few.positions) EXPECT_TRUE(std::isfinite(number));
    EXPECT_EQ(few.normals.size(), few.positions.size());
  }
}

std::vector<float> repeated(std::size_t count, const std::vector<float>& point) {
  std::vector<float> positions;
  for (std::size_t i = 0; i < count; ++i) positions.insert(positions.end(), point.begin(), point.end());
  return positions;
}

TEST(BadPoints, NoneGiveATreeWithoutNodes) {
  expect_sound({});
  const Tree tree{PointSet{}};
  EXPECT_TRUE(tree.nodes().empty());
  EXPECT_EQ(tree.leaf_of({0, 0, 0}), none);
  EXPECT_EQ(tree.leaf_count(), 0U);
}

TEST(BadPoints, OneIsALeaf) {
  expect_sound({1, 2, 3});
  const std::vector<float> positions{1, 2, 3};
  const Tree tree({.positions = positions});
  EXPECT_EQ(tree.leaf_count(), 1U);
  EXPECT_EQ(tree.leaf_of({1, 2, 3}), 0U);
}

TEST(BadPoints, EqualOnesAreALeaf) {
  const std::vector<float> positions = repeated(1000, {1e6F, -2, 3});
  expect_sound(positions);
  EXPECT_EQ(Tree({.positions = positions}).leaf_count(), 1U);
}

TEST(BadPoints, OnALineAreDivided) {
  std::vector<float> positions;
  for (int i = 0; i < 500; ++i) {
    const auto t = static_cast<float>(i);
    positions.insert(positions.end(), {t, 2 * t, -t});
  }
  expect_sound(positions);
}

TEST(BadPoints, OnAPlaneAreOneHeightField) {
  std::vector<float> positions;
  for (int i = 0; i < 900; ++i) {
    const int row = i / 30;
    positions.insert(positions.end(), {static_cast<float>(i % 30), static_cast<float>(row), 5});
  }
  expect_sound(positions);
  const Tree tree({.positions = positions});
  EXPECT_EQ(tree.leaf_count(), 1U);
  EXPECT_EQ(tree.nodes()[0].kind, Kind::transition);
}

TEST(BadPoints, AMillionDuplicatesAmongOthersAreOneLeaf) {
  Shape shape = sphere(2000);
  const std::vector<float> many = repeated(1000000, {0.6F, 0.8F, 0});
  shape.positions.insert(shape.positions.end(), many.begin(), many.end());
  shape.normals.resize(shape.positions.size());  // all normals are missing
  const Tree tree(shape.points(), {.threshold = 0});
  EXPECT_EQ(tree.nodes()[tree.leaf_of({0.6F, 0.8F, 0})].size(), 1000000U);
  EXPECT_LE(tree.leaf_count(), 2001U);
}

TEST(BadPoints, FarFromTheOriginKeepTheirOrder) {
  Shape shape = sphere(3000);
  for (float& number : shape.positions) number += 4e5F;  // at such coordinates, a float has a step of 1/32
  expect_sound(shape.positions);
}

TEST(BadPoints, TinyAndHugeOnesAreDividedAlike) {
  for (const float scale : {1e-30F, 1e17F}) {
    Shape shape = sphere(3000);
    for (float& number : shape.positions) number *= scale;
    EXPECT_GT(Tree(shape.points(), {.threshold = 0.01F}).leaf_count(), 50U) << scale;
    expect_sound(shape.positions);
  }
}

TEST(BadPoints, WithoutSomeNormalsAreDivided) {
  Shape shape = torus(100);
  for (std::size_t i = 0; i < shape.normals.size(); ++i) {
    if (i / 3 % 2 == 0) shape.normals[i] = 0;
  }
  const Tree tree(shape.points(), {.threshold = 1e-3F});
  EXPECT_GT(tree.frames().size(), 8U);
  for (float& number : shape.normals) number = 0;
  EXPECT_GT(Tree(shape.points(), {.threshold = 1e-3F}).leaf_count(), 100U);
}

TEST(BadPoints, NormalsOfAnyLengthGiveTheSame) {
  const Shape shape = torus(60);
  const auto leaves = static_cast<double>(Tree(shape.points()).leaf_count());
  for (const float length : {1e-25F, 0.5F, 3e20F}) {
    Shape other = shape;
    for (float& number : other.normals) number *= length;
    EXPECT_NEAR(static_cast<double>(Tree(other.points()).leaf_count()), leaves, 0.01 * leaves)
        << length;  // rounding changes the number of leaves a little
  }
}

TEST(BadArgument, CoordinatesAreFinite) {
  for (const float wrong : {std::nanf(""), std::numeric_limits<float>::infinity(), 1e30F}) {
    Shape shape = sphere(10);
    shape.positions[3 * 7 + 1] = wrong;
    expect_error(Element::point, 7, "remove the point", [&] { Tree(shape.points(), {}); });
    expect_error(Element::point, 7, "remove the point", [&] { simplify({shape.points()}, {}); });
    expect_error(Element::point, 7, "remove the point", [&] { estimate_normals(shape.points()); });
  }
}

TEST(BadArgument, NormalsAreFinite) {
  Shape shape = sphere(10);
  shape.normals[3 * 4] = std::nanf("");
  expect_error(Element::point, 4, "make it zero", [&] { Tree(shape.points(), {}); });
}

TEST(BadArgument, ArraysFitThePoints) {
  const Shape shape = sphere(10);
  const std::vector<float> some(7);
  const std::vector<std::uint8_t> bytes(7);
  expect_error(Element::array, 0, "three for each point", [&] { Tree({.positions = some}); });
  expect_error(Element::array, 0, "normals", [&] { Tree({.positions = shape.positions, .normals = some}); });
  expect_error(Element::array, 0, "colours", [&] { Tree({.positions = shape.positions, .colours = bytes}); });
  expect_error(Element::array, 0, "texcoords", [&] { Tree({.positions = shape.positions, .texcoords = some}); });
  expect_error(Element::array, 0, "normals has 30 elements for 0 points", [&] { Tree({.normals = shape.normals}); });
}

TEST(BadArgument, IndicesAreOfPoints) {
  const Shape shape = torus(5);
  std::vector<std::uint32_t> triangles = shape.triangles;
  triangles[3 * 9 + 2] = 25;
  expect_error(Element::triangle, 9, "index 25 of 25", [&] { simplify({shape.points(), triangles}); });
  triangles.resize(8);
  expect_error(Element::array, 0, "three for each", [&] { simplify({shape.points(), triangles}); });
}

TEST(BadArgument, OptionsAreInRange) {
  const Shape shape = sphere(10);
  expect_error(Element::option, 0, "threshold", [&] { Tree(shape.points(), {.threshold = -1}); });
  expect_error(Element::option, 0, "delta_a", [&] { Tree(shape.points(), {.delta_a = 2}); });
  expect_error(Element::option, 0, "delta_d", [&] { Tree(shape.points(), {.delta_d = std::nanf("")}); });
  expect_error(Element::option, 0, "delta_d", [&] { simplify(shape.mesh(), {.delta_d = -1}); });
  expect_error(Element::option, 0, "threshold", [&] { simplify(shape.mesh(), {.threshold = std::nanf("")}); });
  expect_error(Element::option, 0, "neighbours", [&] { estimate_normals(shape.points(), {.neighbours = 2}); });
}

}  // namespace
}  // namespace glark::vstree::test
