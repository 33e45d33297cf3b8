// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/programs/derived_key.h"

#include <gtest/gtest.h>

#include "glark/core/weld/weld.h"

namespace glark::core {
namespace {

class DerivedKeys : public testing::Test {
 protected:
  DerivedKey key(const KeyRequest& request = {}) const {
    return derived_key({options, ark, bindings, capabilities}, program, request);
  }

  ContextOptions options;
  ArkState ark;
  Bindings bindings;
  Capabilities capabilities;
  Program program;
};

TEST_F(DerivedKeys, TheProvokingCornerFollowsTheConvention) {
  program.traits.copies_provoking_vertex = true;
  bindings.provoking_vertex = GL_LAST_VERTEX_CONVENTION;
  EXPECT_EQ(key().provoking_corner, 2);
  bindings.provoking_vertex = GL_FIRST_VERTEX_CONVENTION;
  EXPECT_EQ(key().provoking_corner, 0);
}

// So that quads and triangles of one transform feedback have one derived program.
TEST_F(DerivedKeys, TheConventionCountsOnlyWhereItShows) {
  bindings.provoking_vertex = GL_FIRST_VERTEX_CONVENTION;
  EXPECT_EQ(key().provoking_corner, 2);
  bindings.shade_model = GL_FLAT;
  EXPECT_EQ(key().provoking_corner, 0);
  bindings.shade_model = GL_SMOOTH;
  program.fields = {{.name = "gl_InstanceID", .type = GL_INT}, {.name = "position", .type = GL_FLOAT_VEC4}};
  EXPECT_EQ(key().provoking_corner, 2);
  program.fields.push_back({.name = "index", .type = GL_INT_VEC2});
  EXPECT_EQ(key().provoking_corner, 0);
}

TEST_F(DerivedKeys, QuadsMayKeepTheirLastVertex) {
  program.traits.copies_provoking_vertex = true;
  bindings.provoking_vertex = GL_FIRST_VERTEX_CONVENTION;
  capabilities.quads_follow_convention = false;
  EXPECT_EQ(key({.mode = GL_QUAD_STRIP}).provoking_corner, 2);
  EXPECT_EQ(key({.mode = GL_TRIANGLES}).provoking_corner, 0);
}

TEST_F(DerivedKeys, FlatShadingIsOfCompatibilityContexts) {
  bindings.shade_model = GL_FLAT;
  EXPECT_TRUE(key().flat_colors);
  capabilities.api = Capabilities::Api::core;
  EXPECT_FALSE(key().flat_colors);
  EXPECT_FALSE(key().clamp_colors);
}

TEST_F(DerivedKeys, WeldingIsTheUsersInTransparentRefinement) {
  options.weld = true;
  EXPECT_FALSE(key().welded);
  options.transparent = true;
  EXPECT_TRUE(key().welded);
}

TEST_F(DerivedKeys, WeldedWordsNeedWelding) {
  ark.displacement.unit = 0;
  DerivedKey apart = key();
  add_welded_words(apart, true);
  EXPECT_FALSE(apart.turns || apart.border);
  ark.weld = true;
  DerivedKey welded = key();
  add_welded_words(welded, true);
  EXPECT_TRUE(welded.turns && welded.border);
}

TEST_F(DerivedKeys, CreasesLimitTransparentRefinementOnly) {
  options.crease = 30;
  EXPECT_EQ(crease_of(options), weld::no_crease);
  options.transparent = true;
  EXPECT_EQ(crease_of(options), 30);
}

TEST_F(DerivedKeys, WhatTheDrawAsksForIsInTheKey) {
  const DerivedKey asked = key({.refinement = Refinement::pn, .tagged = true, .placed = true, .morphing = true});
  EXPECT_EQ(asked.refinement, Refinement::pn);
  EXPECT_TRUE(asked.tagged && asked.placed && asked.morphing);
  EXPECT_FALSE(key().tagged || key().placed || key().morphing);
}

}  // namespace
}  // namespace glark::core
