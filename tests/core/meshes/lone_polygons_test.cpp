// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: polygons that glBegin..glEnd draws one by one.
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

// The edges of a body come apart if each of its polygons is a draw of its own: the normals of a panel look like those of a
// ball's facet.
TEST(LonePolygons, StayAsTheyAre) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  glEnable(GL_DEPTH_TEST);
  const std::vector<std::array<GLfloat, 3>> corners = ball_corners();
  for (const GLenum mode : {GL_TRIANGLES, GL_POLYGON, GL_TRIANGLE_STRIP}) {
    const std::vector<Picture> frames = draw_frames(5, [&] {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i % 3 == 0) glBegin(mode);
        glNormal3fv(corners[i].data());
        glVertex3fv(corners[i].data());
        if (i % 3 == 2) glEnd();
      }
    });
    EXPECT_TRUE(frames[4] == frames[0]) << mode;
    EXPECT_NEAR(covered_pixels(frames[4]), octahedron_pixels, octahedron_pixels / 50) << mode;
  }
}

}  // namespace
}  // namespace glark::core::test
