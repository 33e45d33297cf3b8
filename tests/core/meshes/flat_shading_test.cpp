// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: what glShadeModel(GL_FLAT) shows in one colour a triangle.
#include <vector>

#include "tests/core/meshes/ball.h"
#include "tests/core/meshes/under_glark_run.h"

namespace glark::core::test {
namespace {

class FlatShading : public testing::TestWithParam<Source> {
 protected:
  FlatShading() {
    for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0}) glEnable(capability);
  }
  // The last of five frames.
  static int pixels(const Ball& ball) {
    return covered_pixels(draw_frames(5, [&] { ball.draw(); })[4]);
  }

 private:
  const OsmesaContext context_{Profile::compatibility};
};

TEST_P(FlatShading, KeepsTrianglesFlat) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  glShadeModel(GL_FLAT);
  EXPECT_NEAR(pixels(ball), octahedron_pixels, octahedron_pixels / 50);
}

TEST_P(FlatShading, Matters) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  EXPECT_GT(pixels(ball), round_pixels);
}

TEST_P(FlatShading, FlattensARoundMeshAtOnce) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  EXPECT_GT(pixels(ball), round_pixels);
  glShadeModel(GL_FLAT);
  EXPECT_NEAR(covered_pixels(draw_frames(1, [&] { ball.draw(); })[0]), octahedron_pixels, octahedron_pixels / 50);
}

// Smooth does not overrule a program that asks for a curved refinement itself.
TEST_P(FlatShading, IsWhatAProgramThatCallsTheExtensionMayAskFor) {
  ASSERT_TRUE(as_under_glark_run);
  const Ball ball(GetParam());
  glShadeModel(GL_FLAT);
  glARKinit(3);
  glEnable(GL_ARK);
  glARKParameteriARK(GL_REFINEMENT_ARK, GL_CURVED_PN_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  EXPECT_GT(pixels(ball), round_pixels);
}

INSTANTIATE_TEST_SUITE_P(AllSources, FlatShading,
                         testing::Values(Source::buffer, Source::client_memory, Source::list, Source::immediate),
                         source_name);

}  // namespace
}  // namespace glark::core::test
