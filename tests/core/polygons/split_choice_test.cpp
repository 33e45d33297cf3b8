// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/split_choice.h"

#include <gtest/gtest.h>

namespace glark::polygons {
namespace {

const auto nothing = [] {};

core::DrawCall quads() { return {.mode = GL_QUADS, .triangles = 4, .whole_polygons = true, .issue = nothing}; }

TEST(SplitChoice, QuadsAreSplit) { EXPECT_TRUE(splits_at_centroid(quads(), {}, {})); }

TEST(SplitChoice, TrianglesAreNot) {
  core::DrawCall call = quads();
  call.mode = GL_TRIANGLES;
  EXPECT_FALSE(splits_at_centroid(call, {}, {}));
}

TEST(SplitChoice, PolygonsMustBeToldApart) {
  core::DrawCall call = quads();
  call.mode = GL_POLYGON;
  EXPECT_TRUE(splits_at_centroid(call, {}, {}));
  call.exact = false;
  EXPECT_FALSE(splits_at_centroid(call, {}, {}));
  const core::PolygonSides sides{5, 3};
  call.polygon_sides = &sides;
  EXPECT_TRUE(splits_at_centroid(call, {}, {}));
}

TEST(SplitChoice, InexactQuadsAreStillQuads) {
  core::DrawCall call = quads();
  call.exact = false;
  EXPECT_TRUE(splits_at_centroid(call, {}, {}));
}

TEST(SplitChoice, FlatValuesHaveNoCentroid) {
  core::Bindings flat;
  flat.shade_model = GL_FLAT;
  EXPECT_FALSE(splits_at_centroid(quads(), {}, flat));
  core::Program program;
  program.traits.writes_flat_outputs = true;
  EXPECT_FALSE(splits_at_centroid(quads(), program, {}));
}

TEST(SplitChoice, IntegersThatVaryHaveNoCentroid) {
  core::Program program;
  program.fields.push_back({.name = "gl_InstanceID", .type = GL_INT, .words = 1});
  EXPECT_TRUE(splits_at_centroid(quads(), program, {}));
  program.fields.push_back({.name = "bone", .type = GL_INT, .location = 1, .words = 1});
  EXPECT_FALSE(splits_at_centroid(quads(), program, {}));
}

}  // namespace
}  // namespace glark::polygons
