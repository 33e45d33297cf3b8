// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/mesh_pass.h"

#include <gtest/gtest.h>

namespace glark::core {
namespace {

class MeshPasses : public testing::Test {
 protected:
  MeshPasses() { bindings_.depth_test = true; }
  MeshPass pass(std::optional<Cause> cause = std::nullopt) const {
    return mesh_pass({bindings_, depth_buffer_, color_buffer_}, cause).value();
  }
  Bindings bindings_;
  bool depth_buffer_ = true;
  bool color_buffer_ = true;
};

TEST_F(MeshPasses, ADrawWithoutCauseCurves) {
  EXPECT_TRUE(pass().curves);
  EXPECT_FALSE(pass(Cause::side_effects).curves);
}

TEST_F(MeshPasses, DepthIsUsedWhereItIsTestedOrWritten) {
  EXPECT_TRUE(pass().uses_depth && pass().writes_depth);
  bindings_.depth_writes = false;
  EXPECT_TRUE(pass().uses_depth);
  EXPECT_FALSE(pass().writes_depth);
  bindings_.depth_function = GL_ALWAYS;
  EXPECT_FALSE(pass().uses_depth);
  bindings_ = {};
  EXPECT_FALSE(pass().uses_depth || pass().writes_depth) << "without the test, GL writes no depth either";
}

TEST_F(MeshPasses, APreparationHasNoColors) {
  EXPECT_FALSE(pass().prepares());
  bindings_.color_writes = false;
  EXPECT_TRUE(pass().prepares());
  bindings_.depth_writes = false;  // the box of an occlusion query
  EXPECT_FALSE(pass().prepares());
  bindings_.stencil_test = true;  // a shadow volume
  EXPECT_TRUE(pass().prepares());
}

TEST_F(MeshPasses, WithoutAStencilBufferNothingIsMarked) {
  bindings_.stencil_test = true;
  MeshPassFacts facts{bindings_};
  EXPECT_TRUE(mesh_pass(facts, std::nullopt)->marks);
  facts.stencil = 0;
  EXPECT_FALSE(mesh_pass(facts, std::nullopt)->marks);
}

TEST_F(MeshPasses, AShadowMapHasNoColors) {
  color_buffer_ = false;
  EXPECT_TRUE(pass().prepares());
}

// It clears the depth buffer, or copies depth from a texture.
TEST_F(MeshPasses, AQuadThatSetsAllDepthsPreparesNothing) {
  bindings_.color_writes = false;
  bindings_.depth_function = GL_ALWAYS;
  const auto prepares = [this](std::uint64_t triangles) {
    const std::optional<MeshPass> found = mesh_pass({bindings_, true, true, triangles}, Cause::no_surface);
    return found && found->prepares();
  };
  EXPECT_FALSE(prepares(2));
  EXPECT_TRUE(prepares(3));
  EXPECT_TRUE(prepares(0)) << "their number is not known";
  bindings_.stencil_test = true;  // a mask
  EXPECT_TRUE(prepares(2));
  bindings_.stencil_test = false;
  bindings_.depth_function = GL_LESS;
  EXPECT_TRUE(prepares(2));
}

TEST_F(MeshPasses, AFramebufferWithoutDepthUsesNone) {
  depth_buffer_ = false;
  bindings_.depth_function = GL_EQUAL;
  EXPECT_FALSE(pass().uses_depth || pass().writes_depth || pass().must_meet());
}

TEST_F(MeshPasses, EqualMustMeet) {
  bindings_.depth_function = GL_EQUAL;
  EXPECT_TRUE(pass().must_meet());
  bindings_.depth_test = false;
  EXPECT_FALSE(pass().must_meet());
}

// It copies a shadow map into another one, which was just cleared.
TEST_F(MeshPasses, AQuadWhoseFragmentsComputeDepthPreparesNothing) {
  bindings_.color_writes = false;
  bindings_.depth_function = GL_LEQUAL;
  MeshPassFacts facts{.bindings = bindings_, .triangles = 2, .fragment_depth = true};
  EXPECT_FALSE(mesh_pass(facts, Cause::no_surface));
  facts.fragment_depth = false;
  EXPECT_TRUE(mesh_pass(facts, Cause::no_surface)->prepares());
  facts.fragment_depth = true;
  facts.triangles = 3;
  EXPECT_TRUE(mesh_pass(facts, Cause::no_surface)->prepares());
}

TEST_F(MeshPasses, StrictComparisonsMeetNothing) {
  for (const auto& [function, meets] : {std::pair(GL_LESS, false),
                                        {GL_GREATER, false},
                                        {GL_ALWAYS, false},
                                        {GL_NEVER, false},
                                        {GL_LEQUAL, true},
                                        {GL_EQUAL, true},
                                        {GL_NOTEQUAL, true}}) {
    bindings_.depth_function = static_cast<GLenum>(function);
    EXPECT_EQ(pass().meets_depth, meets) << function;
  }
  bindings_.depth_function = GL_LESS;
  bindings_.polygon_offset = true;
  EXPECT_TRUE(pass().meets_depth) << "the offset may lift it off the pass that it lies on";
  bindings_.depth_test = false;
  EXPECT_FALSE(pass().meets_depth);
}

TEST_F(MeshPasses, TheTargetIsTheFramebufferAndTheViewport) {
  const std::uint64_t window = pass().target;
  EXPECT_NE(window, 0);
  EXPECT_NE(mesh_pass({.bindings = bindings_, .framebuffer = 1}, std::nullopt)->target, window);
  bindings_.viewport = {512, 512};
  EXPECT_NE(pass().target, window);
}

TEST_F(MeshPasses, LinesNeedNotMeetToTheBit) {
  bindings_.depth_function = GL_EQUAL;
  EXPECT_FALSE(pass(Cause::not_triangles).must_meet());
  EXPECT_TRUE(pass(Cause::not_triangles).uses_depth);
}

// Sparks in a shadow map meet the sparks that show, and nothing else.
TEST_F(MeshPasses, LinesPrepareForNoSurface) {
  bindings_.color_writes = false;
  bindings_.stencil_test = true;
  EXPECT_TRUE(pass().prepares());
  EXPECT_FALSE(pass(Cause::not_triangles).prepares());
}

TEST_F(MeshPasses, NoPictureSaysNothing) {
  for (const Cause cause : {Cause::render_mode, Cause::rasterizer_discard, Cause::invalid_draw, Cause::level_zero,
                            Cause::screen_quad, Cause::overlay, Cause::orthographic}) {
    EXPECT_FALSE(mesh_pass({bindings_, depth_buffer_, color_buffer_}, cause).has_value()) << text_of(cause).key;
  }
}

}  // namespace
}  // namespace glark::core
