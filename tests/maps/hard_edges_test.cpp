// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Machine parts: creases stay sharp, and smooth surfaces have none.
#include "glark/clients/maps/charts/hard_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glark/clients/maps/charts/segmentation.h"
#include "tests/maps/bumpy_sphere.h"
#include "tests/maps/seen_model.h"

namespace glark::maps::test {
namespace {

// A box, turned so that no edge is along a row of texels. `parts` squares along an edge.
Sphere box(std::uint32_t parts) {
  Sphere mesh;
  for (std::size_t face = 0; face < 6; ++face) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    for (std::uint32_t row = 0; row <= parts; ++row) {
      for (std::uint32_t column = 0; column <= parts; ++column) {
        const double u = 2.0 * column / parts - 1, v = 2.0 * row / parts - 1;
        Precise p;
        p[face % 3] = face < 3 ? 1 : -1;
        p[(face + 1) % 3] = face < 3 ? u : v;
        p[(face + 2) % 3] = face < 3 ? v : u;
        const Precise turned = common::unit(Precise{1, 2, 3}) * p.x + common::unit(Precise{-2, 1, 0}) * p.y +
                               common::unit(Precise{-3, -6, 5}) * p.z;
        for (std::size_t k = 0; k < 3; ++k) mesh.positions.push_back(static_cast<float>(turned[k]));
      }
    }
    for (std::uint32_t row = 0; row < parts; ++row)
      for (std::uint32_t column = 0; column < parts; ++column) {
        const std::uint32_t a = first + row * (parts + 1) + column, b = a + 1, c = a + parts + 1, d = c + 1;
        mesh.triangles.insert(mesh.triangles.end(), {a, b, d, a, d, c});
      }
  }
  return mesh;
}

Baked bake_box() {
  const Sphere fine = box(40), coarse = box(3);
  return bake({.positions = coarse.positions, .triangles = coarse.triangles},
              mesh_source({.positions = fine.positions, .triangles = fine.triangles}, 0.05));
}

TEST(HardEdges, ABoxHasItsTwelve) {
  const Baked model = bake_box();
  EXPECT_EQ(model.hard_edges, 12U * 3);
  EXPECT_LE(model.seams.normal.greatest, 1);
}

// Next to an edge, the normal is that of the face up to the last place.
TEST(HardEdges, NormalsDoNotRoundTheEdgesOfABox) {
  const Sphere coarse = box(3);
  const Baked model = bake_box();
  const SeenModel seen_model(model);
  for (std::size_t t = 0; t < model.triangles.size() / 3; ++t) {
    const auto corner = [&](std::size_t k) {
      const float* const p = &coarse.positions[3 * std::size_t{coarse.triangles[3 * t + k]}];
      return Precise{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    };
    const Precise normal = common::unit(common::cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (const std::array<double, 3>& at :
         {std::array{0.498, 0.498, 0.004}, {0.004, 0.498, 0.498}, {0.498, 0.004, 0.498}, {1 / 3.0, 1 / 3.0, 1 / 3.0}})
      EXPECT_GT(common::dot(seen_model.at(t, at).normal, normal), std::cos(0.035)) << "triangle " << t;
  }
}

// A sphere of few triangles meets in large angles, but the fine sphere has no crease.
TEST(HardEdges, ASmoothSurfaceHasNone) {
  const Sphere fine = sphere_of(5, true), coarse = sphere_of(0, false);
  const Baked model = bake(coarse.coarse(), mesh_source(fine.fine(), 0.02), {.reach = 0.4});
  EXPECT_EQ(model.hard_edges, 0U);
}

TEST(HardEdges, WeakEdgesContinueStrongOnes) {
  const Sphere mesh = box(1);
  Surface surface = surface_of({.positions = mesh.positions, .triangles = mesh.triangles});
  constexpr float strong = 0.1F, weak = 0.4F;  // twice these, over a right angle, are 0.13 and 0.51
  std::vector<float> spreads(12, weak);
  find_hard_edges(spreads, surface);
  EXPECT_TRUE(surface.hard.empty());
  for (std::size_t t = 0; t < 4; ++t) spreads[t] = strong;
  find_hard_edges(spreads, surface);
  EXPECT_EQ(count_hard_edges(surface), 12U);
  spreads.assign(12, std::numeric_limits<float>::infinity());
  find_hard_edges(spreads, surface);
  EXPECT_TRUE(surface.hard.empty());
}

TEST(HardEdges, ChartsEndAtThem) {
  const Sphere mesh = box(2);
  Surface surface = surface_of({.positions = mesh.positions, .triangles = mesh.triangles});
  find_hard_edges(std::vector<float>(surface.triangles.size(), 0.0F), surface);
  const std::vector<Chart> charts = segment(surface);
  EXPECT_EQ(charts.size(), 6U);
  for (const Chart& chart : charts) {
    EXPECT_TRUE(chart.guests.empty());
    for (const std::uint32_t t : chart.triangles)
      EXPECT_GT(common::dot(surface.triangle_normals[t], chart.normal), 0.999F);
  }
  const std::vector<Chart> without = segment(surface, false);
  EXPECT_TRUE(std::any_of(without.begin(), without.end(), [&](const Chart& chart) {
    return common::dot(surface.triangle_normals[chart.triangles.front()], chart.normal) < 0.99F;
  }));
}

}  // namespace
}  // namespace glark::maps::test
