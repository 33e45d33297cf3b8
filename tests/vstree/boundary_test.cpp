// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Clusters of open surfaces, and of closed surfaces whose sheets are near to each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <span>
#include <utility>

#include "glark/clients/common/vector.h"
#include "tests/shapes/parts.h"
#include "tests/vstree/shapes.h"

namespace glark::vstree::test {
namespace {

using common::Vector3f;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<Edge> boundary_of(const std::vector<std::uint32_t>& triangles) {
  std::multiset<Edge> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    edges.insert(std::minmax<std::uint32_t>({triangles[i], triangles[i % 3 == 2 ? i - 2 : i + 1]}));
  std::vector<Edge> result;
  std::ranges::copy_if(edges, std::back_inserter(result), [&](const Edge& edge) { return edges.count(edge) == 1; });
  return result;
}

float distance(Vector3f point, Vector3f from, Vector3f to) {
  const Vector3f along = to - from;
  const float at = std::clamp(dot(point - from, along) / dot(along, along), 0.0F, 1.0F);
  return length(point - (from + along * at));
}

// Returns the greatest distance of the first boundary's vertices from the second boundary.
float farthest(std::span<const float> positions, const std::vector<Edge>& edges, std::span<const float> others,
               const std::vector<Edge>& other_edges) {
  float most = 0;
  for (const Edge& edge : edges) {
    float least = 1e30F;
    for (const Edge& other : other_edges)
      least = std::min(least, distance(common::vector_at(positions, edge.first), common::vector_at(others, other.first),
                                       common::vector_at(others, other.second)));
    most = std::max(most, least);
  }
  return most;
}

float diagonal_of(const std::vector<float>& positions) {
  float low[3] = {1e30F, 1e30F, 1e30F}, high[3] = {-1e30F, -1e30F, -1e30F};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], positions[i]);
    high[i % 3] = std::max(high[i % 3], positions[i]);
  }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

// Without planes through the boundary, it is 1.1 to 1.5 % of the diagonal away.
TEST(Clusters, KeepTheBoundary) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const shapes::Part cover = shapes::cover(seed, 4);
    const std::vector<Edge> boundary = boundary_of(cover.triangles);
    ASSERT_FALSE(boundary.empty());
    const Simplified few =
        simplify({{.positions = cover.positions}, cover.triangles}, {.target = cover.triangle_count() / 20});
    const std::vector<Edge> kept = boundary_of(few.triangles);
    const float diagonal = diagonal_of(cover.positions);
    EXPECT_LT(farthest(cover.positions, boundary, few.positions, kept), 0.0015F * diagonal);
    EXPECT_LT(farthest(few.positions, kept, cover.positions, boundary), 0.0015F * diagonal);
  }
}

// A closed tube around a helix. Its turns nearly touch.
Shape coil(std::uint32_t around, float gap) {
  constexpr float pi = 3.14159265F, radius = 0.1F;
  Shape shape;
  const std::uint32_t along = 60 * around;
  for (std::uint32_t i = 0; i <= along; ++i) {
    const float u = 10 * pi * static_cast<float>(i) / static_cast<float>(along);
    for (std::uint32_t k = 0; k < around; ++k) {
      const float v = 2 * pi * static_cast<float>(k) / static_cast<float>(around);
      const float r = 1 + radius * std::cos(v);
      shape.positions.insert(shape.positions.end(), {r * std::cos(u), r * std::sin(u),
                                                     (2 * radius + gap) * u / (2 * pi) + radius * std::sin(v)});
      const std::uint32_t a = i * around + k, b = i * around + (k + 1) % around;
      if (i < along) shape.triangles.insert(shape.triangles.end(), {a, a + around, b, b, a + around, b + around});
    }
  }
  for (std::uint32_t k = 2; k < around; ++k) {
    const std::uint32_t last = along * around;
    shape.triangles.insert(shape.triangles.end(), {0, k - 1, k, last, last + k, last + k - 1});
  }
  return shape;
}

// Clusters take points of two turns. Where these touch, up to 1400 crumbs were pinched off.
TEST(Clusters, OfAClosedMeshAreClosedWithoutCrumbs) {
  for (const float gap : {0.002F, 0.005F, 0.01F, 0.02F}) {
    SCOPED_TRACE(gap);
    const Shape shape = coil(40, gap);
    for (const std::size_t divisor : {3U, 8U, 20U, 40U}) {
      const Simplified few =
          simplify({{.positions = shape.positions}, shape.triangles}, {.target = shape.triangles.size() / 3 / divisor});
      const EdgeFaults faults = edge_faults(few.triangles);
      EXPECT_EQ(faults.boundary, 0U);
      EXPECT_EQ(faults.non_manifold, 0U);
      EXPECT_LE(parts_of(few), 40U);
    }
  }
}

// Sheets that face the same way may have equal triangles. With one triangle of each, they had 500 to 2200 open edges.
TEST(Clusters, OfNestedSheetsAreClosed) {
  const Shape shape = nested_tori(150);
  for (const std::size_t target : {3000U, 6000U, 12000U}) {
    const Simplified few = simplify({{.positions = shape.positions}, shape.triangles}, {.target = target});
    const EdgeFaults faults = edge_faults(few.triangles);
    EXPECT_EQ(faults.boundary, 0U);
    EXPECT_EQ(faults.non_manifold, 0U);
  }
}

}  // namespace
}  // namespace glark::vstree::test
