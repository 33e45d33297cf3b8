// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: polygons that glBegin..glEnd draws one by one.
#include <vector>

#include "tests/core/meshes/ball.h"
#include "tests/core/meshes/under_glark_run.h"

namespace glark::core::test {
namespace {

void draw_one_by_one(GLenum mode) {
  const std::vector<std::array<GLfloat, 3>> corners = ball_corners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 3 == 0) glBegin(mode);
    glNormal3fv(corners[i].data());
    glVertex3fv(corners[i].data());
    if (i % 3 == 2) glEnd();
  }
}

// Polygons drawn one by one stay flat. A panel's normals may look like a ball's, so curving each panel by itself would
// open its edges.
TEST(LonePolygons, StayAsTheyAre) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0}) glEnable(capability);
  for (const GLenum mode : {GL_TRIANGLES, GL_POLYGON, GL_TRIANGLE_STRIP}) {
    const std::vector<Picture> frames = draw_frames(5, [mode] { draw_one_by_one(mode); });
    EXPECT_TRUE(frames[4] == frames[0]) << mode;
    EXPECT_NEAR(covered_pixels(frames[4]), octahedron_pixels, octahedron_pixels / 50) << mode;
  }
}

// The picture of a tree casts a shadow.
TEST(LonePolygons, KeepNothingFlatByTheirShadows) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  const DepthFramebuffer shadow_map;
  const Ball ball(Source::buffer);
  glEnable(GL_DEPTH_TEST);
  const auto draw_polygons = [](GLenum mode, int count) {
    for (int i = 0; i < count; ++i) {
      glBegin(mode);
      for (const auto& [x, y] : {std::pair(-0.9F, -0.9F), {-0.8F, -0.9F}, {-0.8F, -0.8F}, {-0.9F, -0.8F}}) {
        glVertex3f(x, y, 0);
      }
      glEnd();
    }
  };
  const auto draw_with_shadows = [&](GLenum mode, int count) {
    return draw_frames(4, [&] {
      shadow_map.bind();
      draw_polygons(mode, count);
      DepthFramebuffer::unbind();
      glEnable(GL_LIGHTING);
      glEnable(GL_LIGHT0);
      ball.draw();
      glDisable(GL_LIGHTING);
    });
  };
  for (const GLenum mode : {GL_POLYGON, GL_QUADS, GL_TRIANGLE_STRIP}) {
    EXPECT_GT(covered_pixels(draw_with_shadows(mode, 3)[3]), round_pixels) << mode;
  }
  const Picture depth_pass = draw_with_shadows(GL_QUADS, 30)[3];
  EXPECT_NEAR(covered_pixels(depth_pass), octahedron_pixels, octahedron_pixels / 50);
}

// Each is a draw of its own there, too: the tiles of a ground would come apart.
TEST(LonePolygons, StayAsTheyAreInAList) {
  ASSERT_TRUE(as_under_glark_run);
  const OsmesaContext context{Profile::compatibility};
  glEnable(GL_DEPTH_TEST);
  glNewList(1, GL_COMPILE);
  draw_one_by_one(GL_TRIANGLES);
  glEndList();
  const std::vector<Picture> frames = draw_frames(5, [] { glCallList(1); });
  EXPECT_TRUE(frames[4] == frames[0]);
}

}  // namespace
}  // namespace glark::core::test
