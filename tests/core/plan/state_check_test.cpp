// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/plan/unrefined/state_check.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

// The cause for which a draw of triangles under these conditions stays as it is.
struct Setting {
  Bindings bindings = {};
  bool transparent = false;
  bool core_profile = false;
  bool feedback_is_ours = false;
  bool plans_feedback = false;
  GLenum mode = GL_TRIANGLES;
  bool exact = true;

  std::optional<Cause> check() const {
    const auto nothing = [] {};
    return check_state({.mode = mode, .triangles = 1, .exact = exact, .issue = nothing},
                       {bindings, transparent, core_profile, feedback_is_ours, plans_feedback});
  }
};

TEST(StateCheck, EveryModeOfTrianglesIsRefined) {
  for (const GLenum mode : {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    EXPECT_EQ(Setting{.mode = mode}.check(), std::nullopt);
  }
}

TEST(StateCheck, OtherModesHaveNoTriangles) {
  for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_PATCHES, GL_TRIANGLES_ADJACENCY}) {
    EXPECT_EQ(Setting{.mode = mode}.check(), Cause::not_triangles);
  }
}

TEST(StateCheck, SelectionAndFeedbackModeStay) {
  for (const GLenum mode : {GL_SELECT, GL_FEEDBACK}) {
    Setting setting;
    setting.bindings.render_mode = mode;
    EXPECT_EQ(setting.check(), Cause::render_mode);
  }
}

TEST(StateCheck, TransformFeedbackOfTheDriverStays) {
  Setting setting;
  setting.bindings.transform_feedback.active = true;
  EXPECT_EQ(setting.check(), Cause::transform_feedback);
  setting.feedback_is_ours = true;
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.feedback_is_ours = false;
  setting.bindings.transform_feedback.paused = true;
  EXPECT_EQ(setting.check(), std::nullopt);
}

TEST(StateCheck, OnlyFacesThatShowMustBeFilled) {
  Setting setting{.transparent = true};
  setting.bindings.polygon_modes = {GL_FILL, GL_LINE};
  EXPECT_EQ(setting.check(), Cause::polygon_mode);
  setting.bindings.culling.enabled = true;
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.bindings.culling.face = GL_FRONT;
  EXPECT_EQ(setting.check(), Cause::polygon_mode);
  setting.bindings.polygon_modes = {GL_POINT, GL_FILL};
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.bindings.polygon_modes = {GL_POINT, GL_LINE};
  EXPECT_EQ(setting.check(), Cause::polygon_mode);
  setting.bindings.culling.face = GL_FRONT_AND_BACK;
  EXPECT_EQ(setting.check(), std::nullopt);
}

TEST(StateCheck, TransparentRefinementDoesNotShowInQueries) {
  Setting setting;
  setting.bindings.queries.begin(GL_VERTICES_SUBMITTED, 0, 1);
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.transparent = true;
  EXPECT_EQ(setting.check(), Cause::primitive_query);
}

// A capture whose triangles GL alone can count stops one of the application's two queries for that time.
TEST(StateCheck, QueriesAllowRefinementThatTheApplicationAskedFor) {
  Setting setting{.exact = false};
  setting.bindings.queries.begin(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 0, 1);
  setting.bindings.queries.begin(GL_PRIMITIVES_GENERATED, 0, 2);
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.exact = true;
  EXPECT_EQ(setting.check(), std::nullopt);
}

TEST(StateCheck, LinesAndPointsOfPolygonsStayInTransparentRefinement) {
  Setting setting;
  setting.bindings.polygon_modes = {GL_LINE, GL_LINE};
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.transparent = true;
  EXPECT_EQ(setting.check(), Cause::polygon_mode);
}

TEST(StateCheck, WithoutRasterizationOnlyResultsCount) {
  Setting setting;
  setting.bindings.rasterizer_discard = true;
  EXPECT_EQ(setting.check(), Cause::rasterizer_discard);
  setting.plans_feedback = true;
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.plans_feedback = false;
  setting.feedback_is_ours = true;
  EXPECT_EQ(setting.check(), std::nullopt);
  setting.feedback_is_ours = false;
  setting.bindings.queries.begin(GL_PRIMITIVES_GENERATED, 0, 3);
  EXPECT_EQ(setting.check(), std::nullopt);
}

TEST(StateCheck, CoreProfilesNeedAVertexArray) {
  Setting setting{.core_profile = true};
  EXPECT_EQ(setting.check(), Cause::invalid_draw);
  setting.bindings.vertex_array = 1;
  EXPECT_EQ(setting.check(), std::nullopt);
}

}  // namespace
}  // namespace glark::core
