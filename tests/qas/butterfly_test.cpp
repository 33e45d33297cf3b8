// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/qas/meshes.h"

namespace glark::qas::test {
namespace {

Surface butterfly(const ControlMesh& mesh, unsigned splits = 0) {
  Surface surface(mesh.view(), {.scheme = Scheme::modified_butterfly, .splits = splits});
  surface.update(mesh.positions);
  return surface;
}

float cosine(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A graph of z = f(x, y) on 8 x 8 cells, with regular inner vertices.
template <typename F>
ControlMesh graph(F&& f) {
  ControlMesh mesh{"graph", {}, {}};
  for (int i = 0; i <= 8; ++i) {
    for (int j = 0; j <= 8; ++j) {
      for (const double value : {double(j), double(i), f(j, i)}) mesh.positions.push_back(static_cast<float>(value));
    }
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (std::uint32_t j = 0; j < 8; ++j) {
      const std::uint32_t a = 9 * i + j;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, a + 10, a, a + 10, a + 9});
    }
  }
  return mesh;
}

TEST(ModifiedButterfly, InterpolatesTheMesh) {
  for (const ControlMesh& mesh : small_meshes()) {
    for (const unsigned splits : {0U, 1U}) {
      const Surface surface = butterfly(mesh, splits);
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        ASSERT_NEAR(surface.limit_positions()[v].x, mesh.positions[3 * v], 1e-6 * mesh.diagonal()) << mesh.name;
    }
  }
}

TEST(ModifiedButterfly, ReproducesCubicsInside) {
  const auto f = [](double x, double y) { return 0.02 * x * x * y - 0.1 * x * y + 0.05 * y * y * y; };
  const ControlMesh mesh = graph(f);
  const Surface surface = butterfly(mesh);
  const std::uint32_t inside = 2 * (8 * 3 + 3);  // a triangle in the middle: (3, 3), (4, 3), (4, 4)
  const Sample edge = surface.evaluate(inside, {0.5F, 0.5F, 0});
  EXPECT_NEAR(edge.position[0], 3.5, 1e-6);
  EXPECT_NEAR(edge.position[2], f(3.5, 3), 1e-5);
}

TEST(ModifiedButterfly, HasTheNormalsOfQuadraticsInside) {
  const ControlMesh mesh = graph([](double x, double y) { return 0.1 * x * x + 0.2 * x * y; });
  const Surface surface = butterfly(mesh);
  const std::uint32_t inside = 2 * (8 * 3 + 3);
  const Sample corner = surface.evaluate(inside, {1, 0, 0}), middle = surface.evaluate(inside, {0.5F, 0.5F, 0});
  EXPECT_NEAR(-corner.normal[0] / corner.normal[2], 0.2 * 3 + 0.2 * 3, 1e-5);
  EXPECT_NEAR(-corner.normal[1] / corner.normal[2], 0.2 * 3, 1e-5);
  EXPECT_NEAR(-middle.normal[0] / middle.normal[2], 0.2 * 3.5 + 0.2 * 3, 1e-5);
}

// A step does not change the limit. Normals of edges are approximate next to extraordinary vertices. There a step
// changes them a little.
TEST(ModifiedButterfly, HasTheSameLimitAfterAStep) {
  for (const ControlMesh& mesh : {shaken(icosahedron(), 0.02), knot(40, 6), bipyramid(7), shaken(asteroid(2), 0.002)}) {
    const Surface surface = butterfly(mesh), split = butterfly(mesh, 1);
    for (std::size_t t = 0; t < surface.patches().size(); ++t) {
      const Sample corner = surface.evaluate(t, {1, 0, 0}), same = split.evaluate(4 * t, {1, 0, 0});
      EXPECT_GT(cosine(corner.normal, same.normal), 0.99999F) << mesh.name;
      const Sample middle = surface.evaluate(t, {0.5F, 0.5F, 0}), vertex = split.evaluate(4 * t + 3, {1, 0, 0});
      EXPECT_NEAR(middle.position[0], vertex.position[0], 1e-6 * mesh.diagonal()) << mesh.name;
      EXPECT_GT(cosine(middle.normal, vertex.normal), 0.985F) << mesh.name;  // 10 degrees
    }
  }
}

}  // namespace
}  // namespace glark::qas::test
