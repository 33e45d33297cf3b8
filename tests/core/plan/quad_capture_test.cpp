// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/polygons/quad_capture.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

TEST(QuadCapture, QuadsMayKeepTheirLastVertex) {
  Bindings bindings;
  Capabilities capabilities;
  bindings.provoking_vertex = GL_FIRST_VERTEX_CONVENTION;
  capabilities.quads_follow_convention = false;
  EXPECT_TRUE(captures_last_vertex(bindings, capabilities, GL_QUADS));
  EXPECT_FALSE(captures_last_vertex(bindings, capabilities, GL_TRIANGLES));
}

TEST(QuadCapture, SmoothFilledQuadsFollowTheDrawnDiagonal) {
  EXPECT_TRUE(follows_drawn_diagonal({.mode = GL_QUADS}));
  EXPECT_TRUE(follows_drawn_diagonal({.mode = GL_QUAD_STRIP}));
  EXPECT_FALSE(follows_drawn_diagonal({.mode = GL_POLYGON}));
  EXPECT_FALSE(follows_drawn_diagonal({.polygon_mode = GL_LINE}));
}

TEST(QuadCapture, FlatValuesNeedTheProvokingVertex) {
  EXPECT_FALSE(follows_drawn_diagonal({.shade_model = GL_FLAT}));
  EXPECT_FALSE(follows_drawn_diagonal({.writes_flat_outputs = true}));
}

TEST(QuadCapture, TheShapeOfAMeshDoesNotDependOnTheWayItIsDrawn) {
  EXPECT_FALSE(follows_drawn_diagonal({.moves_vertices = true}));
  EXPECT_FALSE(follows_drawn_diagonal({.split = true}));
}

TEST(QuadCapture, TheSourceOfADraw) {
  const auto nothing = [] {};
  EXPECT_EQ(quad_source({.issue = nothing}), polygons::QuadSource::immediate);
  EXPECT_EQ(quad_source({.from_arrays = true, .issue = nothing}), polygons::QuadSource::arrays);
  EXPECT_EQ(quad_source({.from_arrays = true, .indexed = true, .issue = nothing}), polygons::QuadSource::elements);
  EXPECT_EQ(quad_source({.list_segment = 7, .issue = nothing}), polygons::QuadSource::list);
}

}  // namespace
}  // namespace glark::core
