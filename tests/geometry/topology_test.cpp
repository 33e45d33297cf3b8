// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/geometry/measure/topology.h"

#include <gtest/gtest.h>

namespace glark::geometry {
namespace {

TEST(Topology, TetrahedronIsClosed) {
  Geometry geometry;
  geometry.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  geometry.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const Topology topology = topology_of(geometry);
  EXPECT_EQ(0U, topology.boundary_edges);
  EXPECT_EQ(0U, topology.non_manifold_edges);
  EXPECT_EQ(1U, topology.components);
  EXPECT_EQ(4U, topology.largest_component);
}

TEST(Topology, SeamsOfAttributesAreNoBoundary) {
  Geometry geometry;
  geometry.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, -0.0F, 1, 1, 0};
  geometry.triangles = {0, 1, 2, 3, 5, 4};
  const Topology topology = topology_of(geometry);
  EXPECT_EQ(4U, topology.places);
  EXPECT_EQ(4U, topology.boundary_edges);
  EXPECT_EQ(1U, topology.components);
  EXPECT_EQ(1U, component_count(geometry));
}

TEST(Topology, ComponentsHaveTriangles) {
  Geometry geometry;
  geometry.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5, 9, 9, 9, 8, 9, 9, 9, 8, 9};
  geometry.triangles = {0, 1, 2, 3, 3, 4, 4, 6, 5};  // the second one is degenerate
  EXPECT_EQ(2U, component_count(geometry));
  EXPECT_EQ(2U, topology_of(geometry).components);
  geometry.triangles.clear();
  EXPECT_EQ(0U, component_count(geometry));
}

// The edges of the middle of a fan are many.
TEST(Topology, EdgesOfAFanAreCounted) {
  Geometry geometry;
  geometry.positions = {0, 0, 0};
  constexpr std::uint32_t count = 100;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float turn = 0.01F * static_cast<float>(i);
    geometry.positions.insert(geometry.positions.end(), {1, turn, turn * turn});
    if (i > 0) geometry.triangles.insert(geometry.triangles.end(), {0, i, i + 1});
  }
  EXPECT_EQ(count + 1, topology_of(geometry).boundary_edges);
  EXPECT_EQ(0U, topology_of(geometry).non_manifold_edges);
}

TEST(Topology, ThreeTrianglesAtAnEdgeAreNotManifold) {
  Geometry geometry;
  geometry.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 9, 9, 9};
  geometry.triangles = {0, 1, 2, 1, 0, 3, 0, 1, 4, 2, 2, 3};
  const Topology topology = topology_of(geometry);
  EXPECT_EQ(1U, topology.non_manifold_edges);
  EXPECT_EQ(6U, topology.boundary_edges);
  EXPECT_EQ(1U, topology.degenerate_triangles);
  EXPECT_EQ(1U, topology.unused_points);
  EXPECT_EQ(1U, connections_of(geometry).non_manifold_edges);
  EXPECT_EQ(1U, connections_of(geometry).components);
}

}  // namespace
}  // namespace glark::geometry
