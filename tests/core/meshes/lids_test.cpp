// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: passes without colours that hide what lies behind them, and that nothing lies on.
#include <cstdlib>
#include <vector>

#include "tests/core/meshes/ball.h"

namespace glark::core::test {
namespace {

// The program runs as under `glark run`. The library reads the variables when the first context is made.
const bool as_under_glark_run = [] {
  return setenv("GLARK_CONFIG", "/dev/null", 1) == 0 && setenv("GLARK_ENABLE", "1", 1) == 0 &&
         setenv("GLARK_REFINE", "smooth", 1) == 0 && setenv("GLARK_LEVEL", "3", 1) == 0;
}();

// A lid hides what lies behind it.
TEST(Lids, KeepNothingFlat) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0}) glEnable(capability);
  const Ball ball(Source::buffer);
  const auto draw_with_lid = [&] {
    ball.draw();
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_LIGHTING);
    glBegin(GL_TRIANGLE_FAN);
    for (const GLfloat x : {-0.9F, -0.85F, -0.8F, -0.85F, -0.88F}) glVertex3f(x, x == -0.85F ? -0.8F : -0.9F, 0);
    glEnd();
    glEnable(GL_LIGHTING);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    ball.draw();
  };
  EXPECT_GT(covered_pixels(draw_frames(4, draw_with_lid)[3]), round_pixels);
  glEnable(GL_POLYGON_OFFSET_FILL);
  const std::vector<Picture> with_offset = draw_frames(2, draw_with_lid);
  EXPECT_NEAR(covered_pixels(with_offset[1]), octahedron_pixels, octahedron_pixels / 50);
}

}  // namespace
}  // namespace glark::core::test
