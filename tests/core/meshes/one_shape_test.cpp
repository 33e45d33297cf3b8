// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// --refine smooth: a mesh is curved in all of its passes or in none. The tests draw an octahedron with the normals of a
// ball. Each frame ends with glFinish. The first frame shows the octahedron as it is without glark.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "tests/core/meshes/ball.h"
#include "tests/core/meshes/under_glark_run.h"

namespace glark::core::test {
namespace {

class OneShape : public testing::TestWithParam<Source> {
 protected:
  OneShape() : ball_(GetParam()) {
    EXPECT_TRUE(as_under_glark_run);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_LIGHT0);
  }
  using State = std::function<void()>;
  void draw_lit(const State& state = [] {}) {
    draw(true, state, [this] { ball_.draw(); });
  }
  // Without lighting, the vertex stage reads no normals. They are there all the same.
  void draw_unlit(const State& state = [] {}) {
    draw(false, state, [this] { ball_.draw(); });
  }
  // There are no normals.
  void draw_flat(const State& state = [] {}) {
    draw(false, state, [this] { ball_.draw_positions(); });
  }
  static void draw(bool lit, const State& state, const State& ball) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    (lit ? glEnable : glDisable)(GL_LIGHTING);
    state();
    ball();
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
  if (GetParam() == Source::buffer) GTEST_SKIP() << "its pre-pass borrows the normals";
  for (const GLenum function : {GL_EQUAL, GL_LEQUAL}) {
    const std::vector<Picture> frames = draw_frames(5, [&] {
      draw_flat(prepare);
      draw_lit([&] { glDepthFunc(function); });
    });
    for (const Picture& frame : frames) EXPECT_TRUE(frame == frames[0]) << function;
    EXPECT_NEAR(covered_pixels(frames[4]), octahedron_pixels, octahedron_pixels / 50);
  }
}

// The pre-pass reads no normals, but the colour pass does: they are bound in both, and so the pre-pass follows.
TEST_P(OneShape, APrepassFollowsByNormalsThatItDoesNotRead) {
  for (const GLenum function : {GL_EQUAL, GL_LEQUAL}) {
    const std::vector<Picture> frames = draw_frames(5, [&] {
      draw_unlit([] { glColor3f(1, 0, 0); });
      draw_lit([&] {
        glColor3f(0, 1, 0);
        glDepthFunc(function);
      });
    });
    if (GetParam() == Source::immediate) {  // without identity, glark cannot tell that both passes have one mesh
      EXPECT_TRUE(frames[4] == frames[0]);
      continue;
    }
    for (const Picture& frame : frames) EXPECT_EQ(red_pixels(frame), 0) << function;
    EXPECT_GT(covered_pixels(frames[4]), round_pixels) << function;
  }
}

TEST_P(OneShape, AProgramFollowsByNormalsThatItDoesNotRead) {
  if (GetParam() == Source::immediate) GTEST_SKIP() << "its draws may be unrelated";
  const GLuint depth = link_program({.vertex = "void main() { gl_Position = ftransform(); }",
                                     .fragment = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }"});
  const std::vector<Picture> frames = draw_frames(4, [&] {
    draw_unlit([&] { glUseProgram(depth); });
    glUseProgram(0);
    draw_lit([] {
      glColor3f(0, 1, 0);
      glDepthFunc(GL_EQUAL);
    });
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
  for (const Picture& frame : frames) EXPECT_EQ(red_pixels(frame), 0);
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
  if (GetParam() != Source::client_memory) GTEST_SKIP() << "a buffer lends its normals; other draws may be unrelated";
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
  if (GetParam() != Source::client_memory) GTEST_SKIP() << "a buffer lends its normals; other draws may be unrelated";
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
    positions.draw_positions();
    glEnable(GL_LIGHTING);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LEQUAL);
    ball.draw();
    glDepthFunc(GL_LESS);
  });
  EXPECT_TRUE(frames[3] == frames[0]);
}

// The shadow map of a mesh is drawn without normals and without colours, into a framebuffer of its own.
TEST_F(OneShapeOf, AMeshIsAsFlatAsItsShadowMap) {
  const Ball ball(Source::client_memory);
  const DepthFramebuffer shadow_map;
  const std::vector<Picture> frames = draw_frames(4, [&] {
    shadow_map.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_LIGHTING);
    ball.draw_positions();
    DepthFramebuffer::unbind();
    glEnable(GL_LIGHTING);
    ball.draw();
  });
  EXPECT_TRUE(frames[3] == frames[0]);
}

TEST_F(OneShapeOf, AShadowMapBorrowsTheNormalsOfItsMesh) {
  const Ball ball(Source::buffer);
  const DepthFramebuffer shadow_map;
  std::vector<GLfloat> depths(std::size_t{picture_size} * picture_size);
  const std::vector<Picture> frames = draw_frames(4, [&] {
    shadow_map.bind();
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_LIGHTING);
    ball.draw_positions();
    glReadPixels(0, 0, picture_size, picture_size, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    DepthFramebuffer::unbind();
    glEnable(GL_LIGHTING);
    ball.draw();
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
  EXPECT_GT(std::count_if(depths.begin(), depths.end(), [](GLfloat depth) { return depth < 1; }), round_pixels);
}

// Red where the pre-pass, which enables only the positions, does not meet the colour pass to the bit.
TEST_F(OneShapeOf, APrepassBorrowsTheNormalsOfItsMesh) {
  const Ball ball(Source::buffer);
  glEnable(GL_COLOR_MATERIAL);
  const std::vector<Picture> frames = draw_frames(4, [&] {
    glDisable(GL_LIGHTING);
    glColor3f(1, 0, 0);
    ball.draw_positions();
    glEnable(GL_LIGHTING);
    glColor3f(0, 1, 0);
    glDepthFunc(GL_EQUAL);
    ball.draw();
    glDepthFunc(GL_LESS);
  });
  EXPECT_GT(covered_pixels(frames[3]), round_pixels);
  for (const Picture& frame : frames) EXPECT_EQ(red_pixels(frame), 0);
}

// The outline of a drawing: the back faces of the mesh, larger, unlit, without normals.
TEST_F(OneShapeOf, AnOutlineBorrowsTheNormalsOfItsMesh) {
  const GLfloat scale = 1.1F;
  const Ball alone(Source::buffer);
  const Ball ball(Source::buffer);
  glEnable(GL_COLOR_MATERIAL);
  glColor3f(0, 1, 0);
  const Picture inner = draw_frames(4, [&] { alone.draw(); })[3];
  const std::vector<Picture> frames = draw_frames(4, [&] {
    glColor3f(0, 1, 0);
    ball.draw();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glDisable(GL_LIGHTING);
    glColor3f(1, 0, 0);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);  // without a projection, the eye looks along +z: the near side is the back side
    glPushMatrix();
    glScalef(scale, scale, scale);
    ball.draw_positions();
    glPopMatrix();
    glPopAttrib();
  });
  const double ring = (scale * scale - 1) * static_cast<GLfloat>(covered_pixels(inner));
  const double tolerance = ring / 5;
  EXPECT_GT(covered_pixels(inner), round_pixels);
  EXPECT_NEAR(covered_pixels(frames[3]), covered_pixels(inner) + ring, tolerance);
  EXPECT_NEAR(red_pixels(frames[3]), ring, tolerance);
}

// What a program can read of its vertex array.
std::vector<GLint64> array_state() {
  std::vector<GLint64> state;
  GLint count = 0;
  glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &count);
  for (GLuint attribute = 0; attribute < static_cast<GLuint>(count); ++attribute) {
    for (const GLenum name : {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
                              GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED,
                              GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_BINDING}) {
      glGetVertexAttribiv(attribute, name, &count);
      state.push_back(count);
    }
    glGetIntegeri_v(GL_VERTEX_BINDING_STRIDE, attribute, &count);
    state.push_back(count);
    GLint64 offset = 0;
    glGetInteger64i_v(GL_VERTEX_BINDING_OFFSET, attribute, &offset);
    state.push_back(offset);
    glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &count);
  }
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &count);
  state.push_back(count);
  return state;
}

TEST_F(OneShapeOf, BorrowedNormalsLeaveNoTrace) {
  const Ball ball(Source::buffer);
  const auto draw_unlit = [&] {
    glDisable(GL_LIGHTING);
    ball.draw_positions();
    glEnable(GL_LIGHTING);
  };
  draw_unlit();
  const std::vector<GLint64> before = array_state();
  const std::vector<Picture> frames = draw_frames(5, [&] {
    ball.draw();
    draw_unlit();
  });
  EXPECT_GT(covered_pixels(frames[4]), round_pixels);
  EXPECT_EQ(array_state(), before);
}

TEST_F(OneShapeOf, NormalsInADeletedBufferAreNotBorrowed) {
  const GLuint positions = make_buffer(GL_ARRAY_BUFFER, ball_corners());
  GLuint normals = make_buffer(GL_ARRAY_BUFFER, ball_corners());
  const auto draw = [&](bool with_normals) {
    glBindBuffer(GL_ARRAY_BUFFER, positions);
    glVertexPointer(3, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_VERTEX_ARRAY);
    if (with_normals) {
      glBindBuffer(GL_ARRAY_BUFFER, normals);
      glNormalPointer(GL_FLOAT, 0, nullptr);
      glEnableClientState(GL_NORMAL_ARRAY);
    }
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(ball_corners().size()));
    glDisableClientState(GL_NORMAL_ARRAY);
  };
  draw_frames(4, [&] { draw(true); });
  glDeleteBuffers(1, &normals);
  normals = make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>(6));
  const std::vector<Picture> frames = draw_frames(1, [&] { draw(false); });
  EXPECT_NEAR(covered_pixels(frames[0]), octahedron_pixels, octahedron_pixels / 50);
}

TEST_F(OneShapeOf, AShadowMapFromAnotherBufferKeepsEverythingFlat) {
  const Ball positions(Source::buffer);
  const Ball ball(Source::buffer);
  const DepthFramebuffer shadow_map;
  const std::vector<Picture> frames = draw_frames(4, [&] {
    shadow_map.bind();
    glDisable(GL_LIGHTING);
    positions.draw_positions();
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
