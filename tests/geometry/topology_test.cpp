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
}

}  // namespace
}  // namespace glark::geometry
