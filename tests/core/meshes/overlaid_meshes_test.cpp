// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: a mesh stays flat under lines that lie on its vertices and are drawn from a buffer of their own.
#include <array>
#include <vector>

#include "tests/core/meshes/ball.h"
#include "tests/core/meshes/under_glark_run.h"

namespace glark::core::test {
namespace {

class OverlaidMeshes : public testing::Test {
 protected:
  // The last of some frames with a ball and lines from its corners to the others, moved by so much.
  static int pixels(GLenum mode, GLfloat moved, bool late = false) {
    EXPECT_TRUE(as_under_glark_run);
    const OsmesaContext context{Profile::compatibility};
    for (const GLenum capability : {GL_DEPTH_TEST, GL_LIGHT0, GL_COLOR_MATERIAL}) glEnable(capability);
    const Ball ball(Source::buffer);
    std::vector<std::array<GLfloat, 3>> corners = ball_corners();
    for (auto& corner : corners) corner[0] += moved;
    const GLuint lines = make_buffer(GL_ARRAY_BUFFER, corners);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    const auto draw = [&](bool with_lines) {
      glEnable(GL_LIGHTING);
      ball.draw();
      if (!with_lines) return;
      glDisable(GL_LIGHTING);
      glBindBuffer(GL_ARRAY_BUFFER, lines);
      glEnableClientState(GL_VERTEX_ARRAY);
      glVertexPointer(3, GL_FLOAT, 0, nullptr);
      glDrawArrays(mode, 0, static_cast<GLsizei>(corners.size()));
      glDisableClientState(GL_VERTEX_ARRAY);
      glBindBuffer(GL_ARRAY_BUFFER, 0);
    };
    draw_frames(4, [&] { draw(!late); });
    return covered_pixels(draw_frames(2, [&] { draw(true); })[1]);
  }
};

TEST_F(OverlaidMeshes, StayFlatUnderLinesBetweenTheirVertices) {
  EXPECT_NEAR(pixels(GL_LINE_LOOP, 0), octahedron_pixels, octahedron_pixels / 20);
  EXPECT_NEAR(pixels(GL_LINE_LOOP, 0, true), octahedron_pixels, octahedron_pixels / 20) << "lines that come later";
}

TEST_F(OverlaidMeshes, AreCurvedUnderPoints) { EXPECT_GT(pixels(GL_POINTS, 0), round_pixels); }

TEST_F(OverlaidMeshes, AreCurvedBesideOtherLines) { EXPECT_GT(pixels(GL_LINE_LOOP, 0.01F), round_pixels); }

}  // namespace
}  // namespace glark::core::test
