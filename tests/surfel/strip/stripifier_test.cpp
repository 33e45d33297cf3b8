// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/strip/stripifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace glark::surfel {
namespace {

using Triangles = std::vector<Triangle>;

// Rotates the triangle, so that the lowest corner comes first.
Triangle normal_form(Triangle triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

std::multiset<Triangle> normal_forms(const Triangles& triangles) {
  std::multiset<Triangle> all;
  for (const Triangle& triangle : triangles) all.insert(normal_form(triangle));
  return all;
}

Triangles decoded(std::span<const std::uint32_t> strip) {
  Triangles all;
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    Triangle triangle = {strip[i], strip[i + 1], strip[i + 2]};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
    if (i % 2 == 1) std::swap(triangle[0], triangle[1]);
    all.push_back(triangle);
  }
  return all;
}

struct Sheet {
  std::vector<Vector> positions;
  Triangles triangles;
};

// A grid of side * side points. Each square has one of its diagonals at random. `bend` makes a ridge along the middle.
Sheet sheet(std::uint32_t side, unsigned seed, float bend = 0) {
  Sheet all;
  std::mt19937 random(seed);
  const std::uint32_t middle = side / 2;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t row = i / side;
    const auto x = static_cast<float>(i % side), y = static_cast<float>(row);
    all.positions.push_back({x, y, -bend * std::fabs(x - static_cast<float>(middle))});
  }
  for (std::uint32_t i = 0; i + side < side * side; ++i) {
    if (i % side + 1 == side) continue;
    const std::uint32_t a = i, b = i + 1, c = i + side + 1, d = i + side;
    const bool first_diagonal = random() % 2 == 0;
    all.triangles.push_back(first_diagonal ? Triangle{a, b, c} : Triangle{a, b, d});
    all.triangles.push_back(first_diagonal ? Triangle{a, c, d} : Triangle{b, c, d});
  }
  std::ranges::shuffle(all.triangles, random);
  return all;
}

// Returns the half-edges that belong to a single triangle.
std::set<std::pair<std::uint32_t, std::uint32_t>> boundary(const Triangles& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> open;
  for (const Triangle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
      const bool fresh = open.erase({to, from}) > 0 || open.insert({from, to}).second;
      EXPECT_TRUE(fresh) << from << ' ' << to;
    }
  }
  return open;
}

TEST(SurfelStripifier, StripHasAllTriangles) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Sheet all = sheet(3 + seed % 12, seed);
    Stripifier stripifier(all.positions, false);
    EXPECT_EQ(normal_forms(decoded(stripifier.stripify(all.triangles))), normal_forms(all.triangles)) << seed;
    EXPECT_EQ(stripifier.flipped_edges(), 0U);
  }
}

// The sets have isolated triangles, three triangles at an edge, triangles on their mirror images, and duplicates.
TEST(SurfelStripifier, StripHasAllTrianglesOfNonManifoldSets) {
  std::mt19937 random(1);
  for (unsigned round = 0; round < 300; ++round) {
    Triangles triangles;
    const std::uint32_t points = 3 + round % 20;
    for (unsigned i = 0; i < 1 + round % 30; ++i) {
      Triangle triangle{};
      for (std::uint32_t& corner : triangle) corner = static_cast<std::uint32_t>(random() % points);
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
      triangles.push_back(triangle);
    }
    const std::vector<Vector> positions(points);
    Stripifier stripifier(positions, false);
    EXPECT_EQ(normal_forms(decoded(stripifier.stripify(triangles))), normal_forms(triangles)) << round;
  }
}

TEST(SurfelStripifier, FullSurfacesNeedLessThanTwoIndicesATriangle) {
  const Sheet all = sheet(20, 4);
  Stripifier stripifier(all.positions, false);
  EXPECT_LT(stripifier.stripify(all.triangles).size(), 2 * all.triangles.size());
}

TEST(SurfelStripifier, NoTrianglesHaveAnEmptyStrip) {
  Stripifier stripifier({}, true);
  EXPECT_TRUE(stripifier.stripify({}).empty());
}

TEST(SurfelStripifier, FlippedEdgesSaveIndicesAndKeepTheBoundary) {
  std::size_t with = 0, without = 0, flipped = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Sheet all = sheet(12, seed);
    Stripifier exact(all.positions, false), flipping(all.positions, true);
    without += exact.stripify(all.triangles).size();
    const auto strip = flipping.stripify(all.triangles);
    with += strip.size();
    flipped += flipping.flipped_edges();
    const Triangles drawn = decoded(strip);
    EXPECT_EQ(drawn.size(), all.triangles.size());
    EXPECT_EQ(boundary(drawn), boundary(all.triangles));
    double area = 0;
    for (const auto& [a, b, c] : drawn) {
      const Vector normal = cross(all.positions[b] - all.positions[a], all.positions[c] - all.positions[a]);
      EXPECT_GT(normal.z, 0);
      area += 0.5 * double{normal.z};
    }
    EXPECT_NEAR(area, 11 * 11, 1e-3);
  }
  EXPECT_GT(flipped, 100U);
  EXPECT_LT(static_cast<double>(with), 0.95 * static_cast<double>(without));
}

TEST(SurfelStripifier, EdgesOfARidgeAreNotFlipped) {
  constexpr std::uint32_t side = 12;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Sheet all = sheet(side, seed, 0.5F);
    Stripifier stripifier(all.positions, true);
    for (const Triangle& triangle : decoded(stripifier.stripify(all.triangles))) {
      const auto on_side = [&](std::uint32_t point, bool left) {
        return left ? point % side <= side / 2 : point % side >= side / 2;
      };
      EXPECT_TRUE(std::ranges::all_of(triangle, [&](std::uint32_t point) { return on_side(point, true); }) ||
                  std::ranges::all_of(triangle, [&](std::uint32_t point) { return on_side(point, false); }));
    }
  }
}

}  // namespace
}  // namespace glark::surfel
