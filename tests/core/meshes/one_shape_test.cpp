// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: a mesh is curved in all of its passes or in none. The tests draw an octahedron with the normals of a
// ball. Each frame ends with glFinish. The first frame shows the octahedron as it is without glark.
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "tests/core/meshes/ball.h"

namespace glark::core::test {
namespace {

// The program runs as under `glark run`. The library reads the variables when the first context is made.
const bool as_under_glark_run = [] {
  return setenv("GLARK_CONFIG", "/dev/null", 1) == 0 && setenv("GLARK_ENABLE", "1", 1) == 0 &&
         setenv("GLARK_REFINE", "smooth", 1) == 0 && setenv("GLARK_LEVEL", "3", 1) == 0;
}();

class OneShape : public testing::TestWithParam<Source> {
 protected:
  OneShape() : ball_(GetParam()) {
    EXPECT_TRUE(as_under_glark_run);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_LIGHT0);
  }
  void draw_flat(const std::function<void()>& state = [] {}) { draw(false, state); }
  void draw_lit(const std::function<void()>& state = [] {}) { draw(true, state); }
  // Without lighting, the vertex stage has no normal.
  void draw(bool lit, const std::function<void()>& state) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    (lit ? glEnable : glDisable)(GL_LIGHTING);
    state();
    ball_.draw();
    glPopAttrib();
  }
  static void prepare() { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); }

  OsmesaContext context_{Profile::compatibility};
  Ball ball_;
};

TEST_P(OneShape, IsRoundFromTheThirdFrameOn) {
  const std::vector<Picture> frames = draw_frames(6, [this] { draw_lit(); });
  EXPECT_EQ(differing_pixels(frames[0], frames[1]), 0);
  EXPECT_NEAR(covered_pixels(frames[1]), octahedron_pixels, octahedron_pixels / 50);
  for (std::size_t i = 2; i < frames.size(); ++i) EXPECT_GT(covered_pixels(frames[i]), round_pixels) << i;
}

TEST_P(OneShape, StaysFlatWithAFlatPrepass) {
  for (const GLenum function : {GL_EQUAL, GL_LEQUAL}) {
    const std::vector<Picture> frames = draw_frames(5, [&] {
      draw_flat(prepare);
      draw_lit([&] { glDepthFunc(function); });
    });
    for (const Picture& frame : frames) EXPECT_TRUE(frame == frames[0]) << function;
    EXPECT_NEAR(covered_pixels(frames[4]), octahedron_pixels, octahedron_pixels / 50);
  }
}

// Red where the second pass does not meet the first one to the bit.
TEST_P(OneShape, CurvedPassesMeetToTheBit) {
  const GLuint red = link_program(
      {.vertex = "varying vec3 n; void main() { n = gl_Normal; gl_Position = ftransform(); }",
       .fragment = "varying vec3 n; void main() { gl_FragColor = vec4(1.0, 0.0, 0.001 * abs(n.x), 1.0); }"});
  const std::vector<Picture> frames = draw_frames(4, [&] {
    draw_lit([&] { glUseProgram(red); });
    glUseProgram(0);
    draw_lit([] {
      glDepthFunc(GL_EQUAL);
      glColor3f(0, 1, 0);
    });
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
  for (const Picture& frame : frames) EXPECT_EQ(red_pixels(frame), 0);
}

TEST_P(OneShape, StaysFlatWithAnOutline) {
  if (GetParam() == Source::immediate) GTEST_SKIP() << "its draws may be unrelated";
  const std::vector<Picture> frames = draw_frames(5, [this] {
    draw_lit();
    draw_flat([] {
      glEnable(GL_CULL_FACE);
      glCullFace(GL_FRONT);
    });
  });
  EXPECT_TRUE(frames[4] == frames[0]);
}

TEST_P(OneShape, AnOverlayWithoutDepthKeepsNothingFlat) {
  const std::vector<Picture> frames = draw_frames(4, [this] {
    draw_flat([] { glDisable(GL_DEPTH_TEST); });
    draw_lit();
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
}

// The second pass counts primitives: it may not be refined at all.
TEST_P(OneShape, AnUnrefinablePartnerKeepsTheMeshUnrefined) {
  GLuint query = 0;
  glGenQueries(1, &query);
  const std::vector<Picture> frames = draw_frames(4, [&] {
    draw_lit();
    glBeginQuery(GL_PRIMITIVES_GENERATED, query);
    draw_lit([] { glDepthFunc(GL_EQUAL); });
    glEndQuery(GL_PRIMITIVES_GENERATED);
  });
  EXPECT_TRUE(frames[3] == frames[0]);
  glDeleteQueries(1, &query);
}

// Selection draws no picture.
TEST_P(OneShape, SelectionKeepsNothingFlat) {
  GLuint hits[16];
  glSelectBuffer(16, hits);
  const std::vector<Picture> frames = draw_frames(4, [this] {
    glRenderMode(GL_SELECT);
    draw_flat();
    glRenderMode(GL_RENDER);
    draw_lit();
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
}

TEST_P(OneShape, AFlatPassThatComesLateMakesTheMeshFlatForGood) {
  if (GetParam() == Source::immediate) GTEST_SKIP() << "its draws may be unrelated";
  draw_frames(4, [this] { draw_lit(); });
  draw_frames(1, [this] { draw_flat(); });
  const std::vector<Picture> frames = draw_frames(4, [this] { draw_lit(); });
  EXPECT_NEAR(covered_pixels(frames[3]), octahedron_pixels, octahedron_pixels / 50);
}

// Stencil shadows: volumes made of the faces of the coarse mesh.
TEST_P(OneShape, StaysFlatWithShadowVolumes) {
  const std::vector<Picture> frames = draw_frames(4, [this] {
    draw_lit();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    prepare();
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glBegin(GL_TRIANGLES);
    for (const GLfloat* corner : {ball_points()[0].data(), ball_points()[2].data(), ball_points()[4].data()}) {
      glVertex3f(2 * corner[0], 2 * corner[1], 2 * corner[2]);
    }
    glEnd();
    glPopAttrib();
  });
  EXPECT_TRUE(frames[3] == frames[0]);
}

INSTANTIATE_TEST_SUITE_P(, OneShape,
                         testing::Values(Source::buffer, Source::client_memory, Source::list, Source::immediate),
                         source_name);

class OneShapeOf : public testing::Test {
 protected:
  OneShapeOf() {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
  }
  OsmesaContext context_{Profile::compatibility};
};

// A head-up display of lines and triangles without normals.
TEST_F(OneShapeOf, UnrelatedImmediateDrawsStayApart) {
  const Ball ball(Source::immediate);
  const std::vector<Picture> frames = draw_frames(4, [&] {
    ball.draw();
    glDisable(GL_LIGHTING);
    for (const GLenum mode : {GL_LINES, GL_TRIANGLES}) {
      glBegin(mode);
      for (const GLfloat x : {-0.9F, -0.8F, -0.8F, -0.9F, -0.9F, -0.85F}) glVertex2f(x, -0.9F);
      glEnd();
    }
    glEnable(GL_LIGHTING);
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
}

// An unlit object beside a lit one.
TEST_F(OneShapeOf, MeshesInOtherBuffersStayApart) {
  const Ball lit(Source::buffer);
  const Ball unlit(Source::buffer);
  const std::vector<Picture> frames = draw_frames(4, [&] {
    lit.draw();
    glDisable(GL_LIGHTING);
    unlit.draw();
    glEnable(GL_LIGHTING);
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
}

TEST_F(OneShapeOf, APrepassFromAnotherBufferKeepsEverythingFlat) {
  const Ball positions(Source::buffer);
  const Ball ball(Source::buffer);
  const std::vector<Picture> frames = draw_frames(4, [&] {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_LIGHTING);
    positions.draw();
    glEnable(GL_LIGHTING);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    ball.draw();
    glDepthFunc(GL_LESS);
  });
  EXPECT_TRUE(frames[3] == frames[0]);
}

// The shadow map of a mesh is drawn without normals and without colours, into a framebuffer of its own.
TEST_F(OneShapeOf, AMeshAndItsShadowMap) {
  const Ball ball(Source::buffer);
  const DepthFramebuffer shadow_map;
  const std::vector<Picture> frames = draw_frames(4, [&] {
    shadow_map.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_LIGHTING);
    ball.draw();
    DepthFramebuffer::unbind();
    glEnable(GL_LIGHTING);
    ball.draw();
  });
  EXPECT_TRUE(frames[3] == frames[0]);
}

TEST_F(OneShapeOf, AShadowMapFromAnotherBufferKeepsEverythingFlat) {
  const Ball positions(Source::buffer);
  const Ball ball(Source::buffer);
  const DepthFramebuffer shadow_map;
  const std::vector<Picture> frames = draw_frames(4, [&] {
    shadow_map.bind();
    glDisable(GL_LIGHTING);
    positions.draw();
    DepthFramebuffer::unbind();
    glEnable(GL_LIGHTING);
    ball.draw();
  });
  EXPECT_TRUE(frames[3] == frames[0]);
}

// The same normal everywhere says nothing about a surface.
TEST_F(OneShapeOf, ADrawWithoutNormalArrayStaysFlat) {
  const Ball ball(Source::buffer);
  glNormal3f(0.6F, 0, 0.8F);
  const std::vector<Picture> frames = draw_frames(4, [&] { ball.draw_positions(); });
  EXPECT_TRUE(frames[3] == frames[0]);
}

// glReadPixels ends the frames of a program that neither swaps buffers nor calls glFinish.
TEST_F(OneShapeOf, AFrameEndsWhereItsPixelsAreRead) {
  const Ball ball(Source::buffer);
  Picture picture;
  for (int frame = 0; frame < 3; ++frame) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    ball.draw();
    picture = read_picture();
  }
  EXPECT_GT(covered_pixels(picture), round_pixels);
}

}  // namespace
}  // namespace glark::core::test
