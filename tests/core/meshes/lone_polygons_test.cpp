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
         setenv("GLARK_REFINE", "smooth", 1) == 0 && setenv("GLARK_LEVEL", "3", 1) == 0 &&
         setenv("GLARK_WAIT", "1", 1) == 0;
}();

void draw_one_by_one(GLenum mode) {
  const std::vector<std::array<GLfloat, 3>> corners = ball_corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) glBegin(mode);
    glNormal3fv(corners[i].data());
    glVertex3fv(corners[i].data());
    if (i % 3 == 2) glEnd();
  }
}

// The edges of a body come apart if each of its polygons is a draw of its own: the normals of a panel look like those of a
// ball's facet.
TEST(LonePolygons, StayAsTheyAre) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  glEnable(GL_DEPTH_TEST);
  for (const GLenum mode : {GL_TRIANGLES, GL_POLYGON, GL_TRIANGLE_STRIP}) {
    const std::vector<Picture> frames = draw_frames(5, [mode] { draw_one_by_one(mode); });
    EXPECT_TRUE(frames[4] == frames[0]) << mode;
    EXPECT_NEAR(covered_pixels(frames[4]), octahedron_pixels, octahedron_pixels / 50) << mode;
  }
}

// The list of a program is one model more often.
TEST(LonePolygons, AreCurvedInAList) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  glEnable(GL_DEPTH_TEST);
  glNewList(1, GL_COMPILE);
  draw_one_by_one(GL_TRIANGLES);
  glEndList();
  const std::vector<Picture> frames = draw_frames(5, [] { glCallList(1); });
  EXPECT_GT(covered_pixels(frames[4]), round_pixels);
}

}  // namespace
}  // namespace glark::core::test
