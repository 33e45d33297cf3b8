// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Charts, their places in the maps, and the feet of points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "glark/clients/maps/atlas/atlas.h"
#include "glark/clients/maps/charts/segmentation.h"
#include "glark/clients/maps/project/coverage.h"
#include "glark/clients/maps/project/shell.h"
#include "tests/maps/bumpy_sphere.h"

namespace glark::maps::test {
namespace {

// A ramp that winds around an axis: a height field everywhere, but it covers itself seen along the axis.
Sphere spiral_ramp() {
  Sphere ramp;
  constexpr std::uint32_t steps = 100;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    const double angle = 0.2 * i;  // three turns
    for (const double radius : {0.5, 1.0}) {
      const Precise p{radius * std::cos(angle), radius * std::sin(angle), 0.05 * angle};
      for (std::size_t k = 0; k < 3; ++k) ramp.positions.push_back(static_cast<float>(p[k]));
    }
    if (i == steps) break;
    const std::uint32_t a = 2 * i;
    ramp.triangles.insert(ramp.triangles.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
  }
  return ramp;
}

// How many of the chart's triangles cover a texel, for the texel that most cover.
int greatest_coverage(const Chart& chart, const Place& place, const Surface& surface) {
  std::vector<int> counts(std::size_t{place.width} * place.height);
  for (const std::uint32_t t : chart.triangles)
    for_each_centre(triangle_in(chart, place, surface, t), 0.05F, [&](int x, int y, const Weights&) {
      ++counts.at(static_cast<std::size_t>(y) * place.width + static_cast<std::size_t>(x));
    });
  return *std::max_element(counts.begin(), counts.end());
}

Atlas atlas_of(const std::vector<Chart>& charts, const Surface& surface, double texels) {
  const std::vector<double> wanted(charts.size(), texels / static_cast<double>(charts.size()));
  return pack(charts, surface, wanted, {.most_texels = 1U << 24U, .most_side = 4096});
}

enum class Shape { sphere, bumps, ramp };

class Segmentation : public testing::TestWithParam<Shape> {
 protected:
  static Sphere shape() {
    switch (GetParam()) {
      case Shape::sphere: return sphere_of(3, false);
      case Shape::bumps: return sphere_of(4, true);
      case Shape::ramp: break;
    }
    return spiral_ramp();
  }
};

TEST_P(Segmentation, GivesEachTriangleToOneChartThatDoesNotCoverItself) {
  const Surface surface = surface_of(shape().coarse());
  const std::vector<Chart> charts = segment(surface);
  std::vector<int> charts_of_triangle(surface.triangles.size());
  const Atlas atlas = atlas_of(charts, surface, 200000);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    for (const std::uint32_t t : charts[c].triangles) ++charts_of_triangle[t];
    EXPECT_EQ(greatest_coverage(charts[c], atlas.places[c], surface), 1);
    for (const std::uint32_t guest : charts[c].guests)
      EXPECT_FALSE(std::binary_search(charts[c].triangles.begin(), charts[c].triangles.end(), guest));
  }
  EXPECT_EQ(std::count(charts_of_triangle.begin(), charts_of_triangle.end(), 1),
            static_cast<std::ptrdiff_t>(surface.triangles.size()));
}

TEST_P(Segmentation, MakesFewCharts) {
  const Surface surface = surface_of(shape().coarse());
  EXPECT_LE(segment(surface).size(), 24U);
}

std::string name_of(const testing::TestParamInfo<Shape>& shape) {
  if (shape.param == Shape::sphere) return "Sphere";
  return shape.param == Shape::bumps ? "Bumps" : "Ramp";
}

INSTANTIATE_TEST_SUITE_P(Shapes, Segmentation, testing::Values(Shape::sphere, Shape::bumps, Shape::ramp), name_of);

TEST(SegmentationOfARamp, CutsWhereItWindsOverItself) {
  EXPECT_GT(segment(surface_of(spiral_ramp().coarse())).size(), 1U);
}

TEST(Surface, VerticesAtOnePositionAreOne) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 3, 5, 4};
  const Surface surface = surface_of({.positions = positions, .triangles = triangles});
  EXPECT_EQ(surface.positions.size(), 4U);
  EXPECT_EQ(surface.neighbours[0][1], 1U);
  EXPECT_EQ(surface.neighbours[0][0], none);
}

TEST(Surface, IsScaledByAPowerOfTwo) {
  const std::vector<float> positions{0, 0, 0, 3e15F, 0, 0, 0, 4e15F, 0};
  const std::vector<std::uint32_t> triangles{0, 1, 2};
  const Surface surface = surface_of({.positions = positions, .triangles = triangles});
  EXPECT_GE(surface.diagonal, 1);
  EXPECT_LT(surface.diagonal, 2);
  EXPECT_EQ(static_cast<double>(surface.positions[1].x) / surface.scale, 3e15F);
}

TEST(Pack, PlacesLieInTheMapsAndDoNotOverlap) {
  const Surface surface = surface_of(sphere_of(4, true).coarse());
  const std::vector<Chart> charts = segment(surface);
  const Atlas atlas = atlas_of(charts, surface, 100000);
  std::vector<int> owners(std::size_t{atlas.width} * atlas.height);
  for (const Place& place : atlas.places) {
    EXPECT_EQ(place.x % gutter, 0U);
    ASSERT_LE(place.x + place.width, atlas.width);
    ASSERT_LE(place.y + place.height, atlas.height);
    for (unsigned y = 0; y < place.height; ++y)
      for (unsigned x = 0; x < place.width; ++x) ++owners[std::size_t{place.y + y} * atlas.width + place.x + x];
  }
  EXPECT_LE(*std::max_element(owners.begin(), owners.end()), 1);
}

TEST(Pack, ChartsLieInTheirPlacesWithAGutter) {
  const Surface surface = surface_of(sphere_of(4, true).coarse());
  const std::vector<Chart> charts = segment(surface);
  const Atlas atlas = atlas_of(charts, surface, 100000);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    for (const std::uint32_t t : charts[c].triangles) {
      for (const Point2& corner : triangle_in(charts[c], atlas.places[c], surface, t).corners) {
        EXPECT_GE(corner[0], static_cast<float>(gutter) - 0.01F);
        EXPECT_GE(corner[1], static_cast<float>(gutter) - 0.01F);
        EXPECT_LE(corner[0], static_cast<float>(atlas.places[c].width - gutter) + 0.01F);
        EXPECT_LE(corner[1], static_cast<float>(atlas.places[c].height - gutter) + 0.01F);
      }
    }
  }
}

TEST(Pack, DensityFollowsTheNumberOfPoints) {
  const Surface surface = surface_of(sphere_of(4, true).coarse());
  const std::vector<Chart> charts = segment(surface);
  ASSERT_GE(charts.size(), 3U);
  std::vector<double> wanted(charts.size(), 10000);
  const Atlas even = pack(charts, surface, wanted, {.most_texels = 1U << 24U, .most_side = 4096});
  wanted[0] *= 4;
  const Atlas uneven = pack(charts, surface, wanted, {.most_texels = 1U << 24U, .most_side = 4096});
  EXPECT_NEAR(uneven.places[0].density[0] / even.places[0].density[0], 2, 1e-3F);
  EXPECT_NEAR(uneven.places[1].density[0] / even.places[1].density[0], 1, 1e-3F);
}

TEST(Shell, FootOfADisplacedPointIsWhereItCameFrom) {
  const Surface surface = surface_of(sphere_of(2, true).coarse());
  const Shell shell(surface, 0.1);
  std::mt19937 random(3);
  std::exponential_distribution<float> part;
  std::uniform_real_distribution<float> height(-0.08F, 0.08F);
  for (int i = 0; i < 5000; ++i) {
    const auto t = static_cast<std::uint32_t>(random() % surface.triangles.size());
    Weights w{part(random), part(random), part(random)};
    const float sum = w[0] + w[1] + w[2];
    Vector position, normal;
    for (std::size_t k = 0; k < 3; ++k) {
      w[k] /= sum;
      position += surface.positions[surface.triangles[t][k]] * w[k];
      normal += surface.normals[surface.triangles[t][k]] * w[k];
    }
    normal = common::unit(normal);
    const float lift = height(random);
    const auto foot = shell.foot_of(position + normal * lift, normal);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->height, lift, 1e-3F);
    Vector found;
    for (std::size_t k = 0; k < 3; ++k)
      found += surface.positions[surface.triangles[foot->triangle][k]] * foot->weights[k];
    EXPECT_LT(common::length(found - position), 2e-3F);
  }
}

TEST(Shell, PointsBeyondTheReachOrOnTheWrongSideHaveNoFoot) {
  const Surface surface = surface_of(sphere_of(2, false).coarse());
  const auto unit = static_cast<float>(surface.scale);
  const Shell shell(surface, 0.1 * surface.scale);
  EXPECT_TRUE(shell.foot_of({0, 0, 1.05F * unit}, {0, 0, 1}));
  EXPECT_TRUE(shell.foot_of({0, 0, 1.05F * unit}, {0, 0, 0}));
  EXPECT_FALSE(shell.foot_of({0, 0, 1.05F * unit}, {0, 0, -1}));
  EXPECT_FALSE(shell.foot_of({0, 0, 1.2F * unit}, {0, 0, 1}));
  EXPECT_FALSE(shell.foot_of({0, 0, 50 * unit}, {0, 0, 1}));
  EXPECT_FALSE(shell.foot_of({0, 0, 0}, {0, 0, 1}));
}

TEST(Coverage, TexelsKnowTheirTriangle) {
  const Surface surface = surface_of(sphere_of(3, false).coarse());
  const std::vector<Chart> charts = segment(surface);
  const Atlas atlas = atlas_of(charts, surface, 50000);
  const Coverage coverage = cover(charts[0], atlas.places[0], surface);
  std::size_t covered = 0;
  for (std::size_t at = 0; at < coverage.triangles.size(); ++at) {
    if (coverage.triangles[at] == none) continue;
    ++covered;
    const Point2 texel =
        triangle_in(charts[0], atlas.places[0], surface, coverage.triangles[at]).at(coverage.weights[at]);
    EXPECT_NEAR(texel[0], static_cast<float>(at % atlas.places[0].width) + 0.5F, 0.01F);
    const std::size_t row = at / atlas.places[0].width;
    EXPECT_NEAR(texel[1], static_cast<float>(row) + 0.5F, 0.01F);
  }
  EXPECT_GT(covered, coverage.triangles.size() / 3);
}

}  // namespace
}  // namespace glark::maps::test
