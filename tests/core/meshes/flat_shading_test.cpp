// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: what glShadeModel(GL_FLAT) shows in one colour a triangle.
#include <cstdlib>
#include <vector>

#include "tests/core/meshes/ball.h"

namespace glark::core::test {
namespace {

// The program runs as under `glark run`. The library reads the variables when the first context is made.
const bool as_under_glark_run = [] {
  return setenv("GLARK_CONFIG", "/dev/null", 1) == 0 && setenv("GLARK_ENABLE", "1", 1) == 0 &&
         setenv("GLARK_REFINE", "smooth", 1) == 0 && setenv("GLARK_LEVEL", "3", 1) == 0 &&
         setenv("GLARK_WAIT", "1", 1) == 0;
}();

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

INSTANTIATE_TEST_SUITE_P(AllSources, FlatShading,
                         testing::Values(Source::buffer, Source::client_memory, Source::list, Source::immediate),
                         source_name);

}  // namespace
}  // namespace glark::core::test
