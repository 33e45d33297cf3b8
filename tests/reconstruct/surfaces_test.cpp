// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Reconstructs known surfaces.
#include <gtest/gtest.h>

#include "tests/reconstruct/meshes.h"

namespace glark::reconstruct::test {
namespace {

constexpr double pi = 3.14159265;

void append(Shape& shape, const Shape& other, float scale, float x) {
  for (std::size_t i = 0; i < other.positions.size(); ++i)
    shape.positions.push_back(scale * other.positions[i] + (i % 3 == 0 ? x : 0));
  shape.normals.insert(shape.normals.end(), other.normals.begin(), other.normals.end());
}

// Returns the root mean square distance from the unit sphere, over the middles of triangles and of edges.
double from_sphere(const Reconstructed& mesh) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (const std::array<double, 3> weights :
         {std::array{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}}) {
      double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        double at = 0;
        for (std::size_t i = 0; i < 3; ++i)
          at += weights[i] * static_cast<double>(mesh.positions[3 * std::size_t{mesh.triangles[t + i]} + k]);
        square += at * at;
      }
      squares += (std::sqrt(square) - 1) * (std::sqrt(square) - 1);
      ++count;
    }
  }
  return std::sqrt(squares / static_cast<double>(count));
}

float off_sphere(float x, float y, float z) { return std::hypot(x, y, z) - 1; }

TEST(Reconstruct, ASphereIsClosedAndRound) {
  const Shape shape = sphere(20000);
  const Reconstructed mesh = reconstruct(shape.points());
  expect_closed(mesh, 1, 2);
  EXPECT_LT(greatest(mesh, off_sphere), 0.002);
  EXPECT_NEAR(volume(mesh), 4 * pi / 3, 0.01);
  EXPECT_EQ(mesh.levels, 2U);
}

TEST(Reconstruct, ATorusHasOneHandle) {
  const Shape shape = torus(150);
  const Reconstructed mesh = reconstruct(shape.points());
  expect_closed(mesh, 1, 0);
  EXPECT_GT(volume(mesh), 0);
}

TEST(Reconstruct, SpheresBesideAndWithinEachOtherStayApart) {
  const Shape one = sphere(20000);
  Shape shape;
  append(shape, one, 1, 0);
  append(shape, one, 0.5F, 2);
  append(shape, one, 0.8F, 0);
  expect_closed(reconstruct(shape.points()), 3, 6);
}

TEST(Reconstruct, SmallPartsAreLeftOut) {
  Shape shape;
  append(shape, sphere(20000), 1, 0);
  append(shape, sphere(200), 0.08F, 2);
  const Reconstructed mesh = reconstruct(shape.points());
  expect_closed(mesh, 1, 2);
  EXPECT_EQ(mesh.left_out, 1U);
  EXPECT_EQ(topology_of(reconstruct(shape.points(), {.least_part = 0})).parts, 2U);
}

// The two sides of the disc are so near to each other that cells contain both.
TEST(Reconstruct, AThinPlateHasTwoSides) {
  Shape shape;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < 200; ++k) {
      const float x = static_cast<float>(i) * 0.01F - 1, y = static_cast<float>(k) * 0.01F - 1;
      for (const float side : {-1.0F, 1.0F}) {
        shape.positions.insert(shape.positions.end(), {x, y, side * 0.03F});
        shape.normals.insert(shape.normals.end(), {0, 0, side});
      }
    }
  }
  const Reconstructed mesh = reconstruct(shape.points());
  expect_manifold(mesh);
  EXPECT_LT(mesh.node_side, 0.06F);
  const double off = greatest(mesh, [](float x, float y, float z) {
    return std::max(std::abs(x), std::abs(y)) > 0.9F ? 0 : std::abs(z) - 0.03F;
  });
  EXPECT_LT(off, 1e-4);
}

TEST(Reconstruct, NoiseIsTakenAway) {
  const Shape shape = sphere(100000, 0.01F);
  const Reconstructed mesh = reconstruct(shape.points());
  expect_closed(mesh, 1, 2);
  EXPECT_GT(mesh.noise, 0.003F);
  EXPECT_LT(greatest(mesh, off_sphere), 0.008);
}

// The scans do not fit: each is a little larger than the scan before.
TEST(Reconstruct, LayersBecomeOneSurface) {
  Shape shape;
  const Shape one = sphere(20000);
  for (int i = 0; i < 5; ++i) append(shape, one, 1 + 0.004F * static_cast<float>(i - 2), 0);
  const Reconstructed mesh = reconstruct(shape.points());
  expect_closed(mesh, 1, 2);
  EXPECT_LT(greatest(mesh, off_sphere), 0.01);
}

TEST(Reconstruct, WhatIsOpenStaysOpen) {
  const Shape whole = sphere(40000);
  Shape half;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[3 * i + 2] < 0) continue;
    half.positions.insert(half.positions.end(), &whole.positions[3 * i], &whole.positions[3 * i] + 3);
    half.normals.insert(half.normals.end(), &whole.normals[3 * i], &whole.normals[3 * i] + 3);
  }
  const Reconstructed mesh = reconstruct(half.points());
  expect_manifold(mesh);
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(topology.parts, 1U);
  EXPECT_EQ(topology.euler, 1);  // a disc
  EXPECT_GT(topology.boundary, 50U);
  const auto below = [&](float, float, float z) { return std::min(z, 0.0F); };
  EXPECT_LT(greatest(mesh, below), 2 * static_cast<double>(mesh.node_side));
}

TEST(Reconstruct, GapsCloseAsFarAsToldTo) {
  const Shape whole = sphere(40000);
  Shape holed;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[3 * i + 2] > 0.99F) continue;  // a hole of radius 0.14
    holed.positions.insert(holed.positions.end(), &whole.positions[3 * i], &whole.positions[3 * i] + 3);
    holed.normals.insert(holed.normals.end(), &whole.normals[3 * i], &whole.normals[3 * i] + 3);
  }
  EXPECT_GT(topology_of(reconstruct(holed.points(), {.gap_edges = 0})).boundary, 0U);
  expect_closed(reconstruct(holed.points(), {.gap_edges = 200}), 1, 2);
}

TEST(Reconstruct, SparseAndDenseSamplesMakeOneSurface) {
  const Shape whole = sphere(60000);
  Shape uneven;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[3 * i] < 0 && i % 6 != 0) continue;
    uneven.positions.insert(uneven.positions.end(), &whole.positions[3 * i], &whole.positions[3 * i] + 3);
    uneven.normals.insert(uneven.normals.end(), &whole.normals[3 * i], &whole.normals[3 * i] + 3);
  }
  expect_closed(reconstruct(uneven.points()), 1, 2);
}

TEST(Reconstruct, DependsOnNeitherThreadsNorScale) {
  const Shape shape = torus(120);
  const Reconstructed one = reconstruct(shape.points(), {.threads = 1});
  const Reconstructed several = reconstruct(shape.points(), {.threads = 4});
  EXPECT_EQ(one.positions, several.positions);
  EXPECT_EQ(one.normals, several.normals);
  EXPECT_EQ(one.triangles, several.triangles);
  for (const float scale : {1.0F / 1024, 4096.0F}) {
    Shape other = shape;
    for (float& number : other.positions) number *= scale;
    const Reconstructed mesh = reconstruct(other.points());
    EXPECT_EQ(mesh.triangles, one.triangles) << scale;
    ASSERT_EQ(mesh.positions.size(), one.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      ASSERT_NEAR(mesh.positions[i] / scale, one.positions[i], 1e-5) << scale;
  }
}

// Returns the colour at a position, in bytes.
std::array<float, 3> paint(const float* position) {
  return {127 + 100 * position[0], 127 + 100 * position[1], position[2] > 0 ? 200.0F : 50.0F};
}

TEST(Reconstruct, ColoursAreThoseOfTheSamplesAround) {
  Shape shape = sphere(40000);
  for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
    for (const float channel : paint(&shape.positions[i])) shape.colours.push_back(static_cast<std::uint8_t>(channel));
  }
  const Reconstructed plain = reconstruct(shape.points());
  const Reconstructed mesh =
      reconstruct({.positions = shape.positions, .normals = shape.normals, .colours = shape.colours});
  EXPECT_TRUE(plain.colours.empty());
  EXPECT_EQ(plain.positions, mesh.positions);
  EXPECT_EQ(plain.normals, mesh.normals);
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.colours.size(); i += 3) {
    const std::array<float, 3> expected = paint(&mesh.positions[i]);
    ASSERT_NEAR(mesh.colours[i], expected[0], 4);
    ASSERT_NEAR(mesh.colours[i + 1], expected[1], 4);
    if (std::abs(mesh.positions[i + 2]) < mesh.node_side) continue;
    ASSERT_EQ(mesh.colours[i + 2], expected[2]);
  }
}

// The sheet has two sides and is thinner than a node.
TEST(Reconstruct, ColoursOfOneSideDoNotShowOnTheOther) {
  Shape shape;
  for (int i = 0; i < 40000; ++i) {
    const int row = i / 200;
    const float x = static_cast<float>(row) * 0.01F - 1, y = static_cast<float>(i % 200) * 0.01F - 1;
    for (const float side : {-1.0F, 1.0F}) {
      shape.positions.insert(shape.positions.end(), {x, y, side * 0.015F});
      shape.normals.insert(shape.normals.end(), {0, 0, side});
      const std::uint8_t level = side > 0 ? 255 : 0;
      shape.colours.insert(shape.colours.end(), {level, level, level});
    }
  }
  const Reconstructed mesh =
      reconstruct({.positions = shape.positions, .normals = shape.normals, .colours = shape.colours});
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    if (std::abs(mesh.positions[i]) > 0.9F || std::abs(mesh.positions[i + 1]) > 0.9F) continue;
    ASSERT_EQ(mesh.colours[i], mesh.normals[i + 2] > 0 ? 255 : 0);
    ++looked_at;
  }
  EXPECT_GT(looked_at, 1000U);
}

TEST(Reconstruct, WhatClosesAGapHasTheColoursAround) {
  const Shape whole = sphere(40000);
  Shape holed;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole.positions[3 * i + 2] > 0.99F) continue;
    holed.positions.insert(holed.positions.end(), &whole.positions[3 * i], &whole.positions[3 * i] + 3);
    holed.normals.insert(holed.normals.end(), &whole.normals[3 * i], &whole.normals[3 * i] + 3);
    holed.colours.insert(holed.colours.end(), {7, 150, 250});
  }
  for (const unsigned levels : {0U, 2U}) {
    const Reconstructed mesh =
        reconstruct({.positions = holed.positions, .normals = holed.normals, .colours = holed.colours},
                    {.levels = levels, .gap_edges = 200});
    expect_closed(mesh, 1, 2);
    for (std::size_t i = 0; i < mesh.colours.size(); i += 3) {
      ASSERT_EQ(mesh.colours[i], 7);
      ASSERT_EQ(mesh.colours[i + 1], 150);
      ASSERT_EQ(mesh.colours[i + 2], 250);
    }
  }
}

TEST(Reconstruct, ThresholdsSmoothAndLevelsEndTheRefinement) {
  const Shape shape = torus(150, 0.002F);
  const Reconstructed fine = reconstruct(shape.points());
  const Reconstructed smooth = reconstruct(shape.points(), {.threshold = 0.005F});
  EXPECT_LT(4 * smooth.base_vertices, fine.base_vertices);
  expect_closed(smooth, 1, 0);
  EXPECT_EQ(reconstruct(shape.points(), {.levels = 0}).levels, 0U);
  EXPECT_EQ(reconstruct(shape.points(), {.levels = 4}).levels, 4U);
}

// Refinement ends at about the given error. So the result has fewer levels.
TEST(Reconstruct, RefinementEndsWhereTheErrorIsMet) {
  const Shape shape = sphere(60000);
  const double diagonal = 2 * std::sqrt(3.0);
  unsigned before = 0;
  for (const float error : {1e-2F, 2.5e-5F, 6e-6F}) {
    const Reconstructed mesh = reconstruct(shape.points(), {.error = error, .levels = 4});
    expect_closed(mesh, 1, 2);
    EXPECT_EQ(mesh.positions, reconstruct(shape.points(), {.levels = mesh.levels}).positions);
    EXPECT_LE(from_sphere(mesh), 1.3 * static_cast<double>(error) * diagonal) << mesh.levels;
    if (mesh.levels > 0) {
      EXPECT_GT(from_sphere(reconstruct(shape.points(), {.levels = mesh.levels - 1})),
                0.7 * static_cast<double>(error) * diagonal)
          << mesh.levels;
    }
    EXPECT_GE(mesh.levels, before);
    before = mesh.levels;
    EXPECT_EQ(error > 1e-3F, mesh.levels == 0U);
  }
  EXPECT_GT(before, 1U);
}

}  // namespace
}  // namespace glark::reconstruct::test
