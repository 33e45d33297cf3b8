// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tests the tags of meshes with hard edges by the resulting surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "glark/pn.h"
#include "tests/pn/meshes.h"

namespace glark::pn::test {
namespace {

Mesh view(const IndexedMesh& mesh, const std::vector<float>& normals = {},
          const std::vector<std::uint32_t>& creases = {}) {
  return {mesh.positions, mesh.triangles, normals, creases};
}

Corner corner(const TaggedMesh& mesh, std::uint32_t vertex) {
  Corner c;
  std::copy_n(&mesh.positions[3 * vertex], 3, c.position.begin());
  std::copy_n(&mesh.normals[3 * vertex], 3, c.normal.begin());
  std::copy_n(&mesh.discontinuities[4 * vertex], 4, c.discontinuity.begin());
  std::copy_n(&mesh.tags[3 * vertex], 3, c.tags.begin());
  return c;
}

std::array<Corner, 3> triangle(const TaggedMesh& mesh, std::size_t t) {
  return {corner(mesh, mesh.triangles[3 * t]), corner(mesh, mesh.triangles[3 * t + 1]),
          corner(mesh, mesh.triangles[3 * t + 2])};
}

std::size_t triangles_of(const TaggedMesh& mesh) { return mesh.triangles.size() / 3; }

using Place = std::array<double, 3>;

// A surface of PN triangles is closed: each edge has two triangles, which give it the same points.
void expect_closed(const TaggedMesh& mesh) {
  std::map<std::pair<Place, Place>, std::vector<std::vector<Place>>> edges;
  for (std::size_t t = 0; t < triangles_of(mesh); ++t) {
    const auto corners = triangle(mesh, t);
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<Place> points;
      for (int i = 0; i <= 8; ++i) {
        std::array<double, 3> weights{};
        weights.at(k) = (8 - i) / 8.0;
        weights.at((k + 1) % 3) = i / 8.0;
        points.push_back(evaluate(corners, weights).position);
      }
      if (points.back() < points.front()) std::reverse(points.begin(), points.end());
      edges[{points.front(), points.back()}].push_back(points);
    }
  }
  for (const auto& [ends, both] : edges) {
    ASSERT_EQ(both.size(), 2U);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_NEAR(both[0][i][axis], both[1][i][axis], 1e-12);
    }
  }
}

// Calls check() for every point of a fine pattern on all triangles.
template <typename Check>
void for_each_sample(const TaggedMesh& mesh, Check&& check) {
  for (std::size_t t = 0; t < triangles_of(mesh); ++t) {
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; i + j <= 8; ++j) check(evaluate(triangle(mesh, t), {(8 - i - j) / 8.0, i / 8.0, j / 8.0}), t);
    }
  }
}

void expect_cube(const TaggedMesh& tagged) {
  EXPECT_EQ(tagged.corners, 8U);
  EXPECT_EQ(triangles_of(tagged), 12U);
  expect_closed(tagged);
  for_each_sample(tagged, [](const Sample& sample, std::size_t) {
    const auto& [x, y, z] = sample.position;
    EXPECT_NEAR(std::max({std::abs(x), std::abs(y), std::abs(z)}), 1, 1e-6);
    const auto& [a, b, c] = sample.normal;
    EXPECT_NEAR(std::max({std::abs(a), std::abs(b), std::abs(c)}), 1, 1e-6) << "of the plane";
  });
}

TEST(DeriveTags, ACubeStaysACube) {
  const TaggedMesh tagged = derive_tags(view(cube()));
  EXPECT_EQ(tagged.sources.size(), 24U);
  EXPECT_EQ(tagged.sources[23][0], tagged.sources[23][1]);
  expect_cube(tagged);
  std::vector<float> normals;
  const IndexedMesh split = unshared(cube(), normals);
  expect_cube(derive_tags(view(split, normals)));
}

void expect_cylinder(const TaggedMesh& tagged, std::uint32_t sides) {
  EXPECT_EQ(tagged.crease_vertices, std::size_t{2} * sides);
  EXPECT_EQ(tagged.corners, 0U);
  expect_closed(tagged);
  for_each_sample(tagged, [](const Sample& sample, std::size_t) {
    const auto& [x, y, z] = sample.position;
    EXPECT_LT(std::abs(z), 1.02) << "caps stay flat up to their rims";
    const double radius = std::hypot(x, y);
    if (std::abs(z) < 0.9) {
      EXPECT_NEAR(radius, 1, 0.03);
    }
    EXPECT_LT(radius, 1.03);
    const auto& n = sample.normal;
    const double wall = (n[0] * x + n[1] * y) / radius;
    if (std::abs(z) < 0.9) {
      EXPECT_GT(wall, 0.99);
    }
    if (radius < 0.8) {
      EXPECT_NEAR(std::abs(n[2]), 1, 1e-6);
    }
  });
}

TEST(DeriveTags, ACylinderIsRoundWithSharpRims) {
  expect_cylinder(derive_tags(view(cylinder(12, true)), {.crease_degrees = 60}), 12);
}

TEST(DeriveTags, EdgesAcrossCapsAreSplit) {
  const IndexedMesh mesh = cylinder(12, false);
  const TaggedMesh tagged = derive_tags(view(mesh), {.crease_degrees = 60});
  EXPECT_EQ(triangles_of(tagged), mesh.triangles.size() / 3 + 2U * 9 * 2)
      << "two more for each of the 9 edges across a cap";
  EXPECT_EQ(tagged.triangle_sources.size(), triangles_of(tagged));
  EXPECT_EQ(tagged.sources.size(), 24U + 18);
  EXPECT_NE(tagged.sources[30][0], tagged.sources[30][1]);
  expect_cylinder(tagged, 12);
  EXPECT_EQ(derive_tags(view(mesh), {.crease_degrees = 60, .split = false}).triangles.size(), mesh.triangles.size());
}

TEST(DeriveTags, SidesGetTheirNormalsBack) {
  std::vector<float> normals;
  const IndexedMesh mesh = unshared(cylinder(12, true), normals);
  // The normals are smooth around the wall and flat on the caps.
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    if (std::abs(normals[i + 2]) > 0.01F) continue;
    std::copy_n(&mesh.positions[i], 2, &normals[i]);
    normals[i + 2] = 0;
  }
  const TaggedMesh tagged = derive_tags(view(mesh, normals));
  expect_cylinder(tagged, 12);
  EXPECT_EQ(tagged.sources.size(), mesh.positions.size() / 3) << "no vertex is added or moved";
  for (std::size_t t = 0; t < triangles_of(tagged); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> weights{};
      weights.at(k) = 1;
      const Sample sample = evaluate(triangle(tagged, t), weights);
      const std::size_t at = 3 * tagged.triangles[3 * t + k];
      const double size = std::hypot(normals[at], normals[at + 1], normals[at + 2]);
      for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(sample.normal[axis], normals[at + axis] / size, 1e-5);
    }
  }
}

TEST(DeriveTags, BiasKeepsToOneSideOfACrease) {
  const TaggedMesh tagged = derive_tags(view(cylinder(12, true)), {.crease_degrees = 60, .bias = 1});
  std::set<int> sides;
  for (std::uint32_t vertex = 0; vertex < 12; ++vertex) {
    sides.insert(tagged.discontinuities[4 * vertex + 2] > 0 ? 1 : -1);
    EXPECT_EQ(tagged.discontinuities[4 * vertex + 3], tagged.discontinuities[3]);
    EXPECT_NE(tagged.discontinuities[4 * (12 + vertex) + 3], tagged.discontinuities[3])
        << "the other rim is another crease";
  }
  EXPECT_EQ(sides.size(), 1U);
}

TEST(DeriveTags, NamedCreases) {
  const IndexedMesh mesh = cylinder(12, true);
  std::vector<std::uint32_t> rims;
  for (std::uint32_t i = 0; i < 12; ++i) {
    rims.insert(rims.end(), {i, (i + 1) % 12, 12 + i, 12 + (i + 1) % 12});
  }
  expect_cylinder(derive_tags(view(mesh, {}, rims), {.crease_degrees = 180}), 12);
  EXPECT_EQ(derive_tags(view(mesh), {.crease_degrees = 180}).crease_vertices, 0U);
}

TEST(DeriveTags, ACreaseMayEnd) {
  const TaggedMesh tagged = derive_tags(view(cylinder(12, true), {}, {{0, 1, 1, 2, 2, 3}}), {.crease_degrees = 180});
  EXPECT_EQ(tagged.crease_vertices, 2U) << "not its two ends";
  expect_closed(tagged);
}

Element element_of(const Mesh& mesh, const Options& options = {}, std::size_t expected_index = 0) {
  try {
    derive_tags(mesh, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.index(), expected_index) << error.what();
    return error.element();
  }
  ADD_FAILURE() << "no error";
  return Element::array;
}

TEST(DeriveTags, Errors) {
  const IndexedMesh good = cube();
  IndexedMesh bad = good;
  bad.positions.pop_back();
  EXPECT_EQ(element_of(view(bad)), Element::array);
  bad = good;
  bad.positions[10] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(element_of(view(bad), {}, 3), Element::vertex);
  bad = good;
  bad.triangles.pop_back();
  EXPECT_EQ(element_of(view(bad), {}, 1), Element::array);
  bad = good;
  bad.triangles[7] = 8;
  EXPECT_EQ(element_of(view(bad), {}, 2), Element::triangle);
  EXPECT_EQ(element_of(view(good, {1, 2, 3}), {}, 2), Element::array);
  EXPECT_EQ(element_of(view(good, {}, {1, 2, 3}), {}, 3), Element::array);
  EXPECT_EQ(element_of(view(good, {}, {0, 1, 9, 1}), {}, 1), Element::crease);
  EXPECT_EQ(element_of(view(good, {}, {0, 7}), {}, 0), Element::crease) << "no edge";
  EXPECT_EQ(element_of(view(good), {.crease_degrees = -1}), Element::option);
  EXPECT_EQ(element_of(view(good), {.sharpness = std::numeric_limits<float>::quiet_NaN()}), Element::option);
  EXPECT_EQ(element_of(view(good), {.tension = 1.5F}), Element::option);
  EXPECT_EQ(element_of(view(good), {.bias = -2}), Element::option);
}

TEST(DeriveTags, MessagesHaveTheValue) {
  const IndexedMesh good = cube();
  const auto problem = [](const Mesh& mesh, const Options& options) -> std::string {
    try {
      derive_tags(mesh, options);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(problem(view(good), {.tension = 1.5F}), "glark-pn: option tension is 1.5; -1 to 1 is possible");
  EXPECT_EQ(problem(view(good, {}, {0, 1, 9, 1}), {}), "glark-pn: crease 1 has the index 9 of 8 vertices; correct it");
  EXPECT_EQ(problem(view(good, {1, 2, 3}), {}),
            "glark-pn: array of normals has 3 numbers, that of positions 24; give as many, or none");
}

void expect_finite(const TaggedMesh& mesh) {
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.tags.size(), mesh.positions.size());
  EXPECT_EQ(mesh.discontinuities.size(), mesh.positions.size() / 3 * 4);
  for (const auto* values : {&mesh.positions, &mesh.normals, &mesh.discontinuities, &mesh.tags}) {
    for (const float value : *values) ASSERT_TRUE(std::isfinite(value));
  }
  for (const std::uint32_t vertex : mesh.triangles) ASSERT_LT(vertex, mesh.sources.size());
  for_each_sample(mesh, [](const Sample& sample, std::size_t) {
    for (const double x : sample.position) ASSERT_TRUE(std::isfinite(x));
    for (const double x : sample.normal) ASSERT_TRUE(std::isfinite(x));
  });
}

TEST(DeriveTags, MeshesOfEveryKind) {
  expect_finite(derive_tags({}));
  IndexedMesh mesh = cube();
  mesh.add(5, 5, 5);                   // isolated
  mesh.face(0, 0, 1);                  // degenerate
  mesh.face(0, 1, 2);                  // at an edge of two other triangles, with the opposite orientation
  mesh.face(3, 2, 1);                  // the same triangle again
  mesh.face(0, mesh.add(1, 0, 0), 7);  // a single edge, and an open one
  const std::uint32_t twin = mesh.add(-0.0F, 0.0F, 3);
  mesh.face(mesh.add(0, -0.0F, 3), twin, 7);  // two vertices at one position
  expect_finite(derive_tags(view(mesh)));
  std::vector<float> normals(mesh.positions.size(), 0);
  normals[4] = std::numeric_limits<float>::infinity();
  normals[7] = std::numeric_limits<float>::quiet_NaN();
  expect_finite(derive_tags(view(mesh, normals)));
  std::mt19937 random(23);
  const auto pick = [&random] { return static_cast<std::uint32_t>(random() % 12); };
  for (int round = 0; round < 50; ++round) {
    IndexedMesh soup;
    for (int i = 0; i < 12; ++i)
      soup.add(static_cast<float>(random() % 3), static_cast<float>(random() % 3), static_cast<float>(random() % 2));
    for (int i = 0; i < 20; ++i) soup.face(pick(), pick(), pick());
    expect_finite(derive_tags(view(soup)));
  }
}

}  // namespace
}  // namespace glark::pn::test
