// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The fixed function, and programs that have only one of its stages. The picture must not change.
#include <array>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

const ModeShape& strip() { return mode_shapes()[1]; }

class FixedFunction : public testing::Test {
 protected:
  OsmesaContext context_{Profile::compatibility};
};

TEST_F(FixedFunction, LitFromBothSides) {
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  const GLfloat red[] = {1, 0, 0, 1};
  const GLfloat blue[] = {0, 0.5F, 1, 1};
  glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
  glMaterialfv(GL_BACK, GL_DIFFUSE, blue);
  glNormal3f(0, 0.3F, 0.9F);
  expect_same_scene({8}, [] {
    for (const GLfloat side : {-1.0F, 1.0F}) {
      glPushMatrix();
      glTranslatef(0.5F * side, 0, 0);
      glScalef(0.5F * side, 0.5F, 0.2F);
      draw_immediate(strip());
      glPopMatrix();
    }
  });
}

TEST_F(FixedFunction, TwoSidedProgram) {
  glEnable(GL_VERTEX_PROGRAM_TWO_SIDE);
  glUseProgram(link_program({.vertex = "#version 120\nvoid main() { gl_Position = ftransform(); gl_FrontColor = "
                                       "gl_Color; gl_BackColor = 1.0 - gl_Color; }\n"}));
  expect_same_scene({8}, [] {
    for (const GLfloat side : {-1.0F, 1.0F}) {
      glPushMatrix();
      glTranslatef(0.5F * side, 0, 0);
      glScalef(0.5F * side, 0.5F, 1);
      draw_immediate(strip());
      glPopMatrix();
    }
  });
}

// One glBegin has more triangles than one capture holds. Most of them have no area.
TEST_F(FixedFunction, ImmediateTrianglesWithoutEnd) {
  constexpr GLuint triangles = 500'000;
  glColor3f(1, 0.5F, 0.25F);
  expect_same_scene({.coarse_triangles = triangles, .level = 0}, [] {
    glBegin(GL_TRIANGLES);
    for (GLuint i = 0; i < triangles; ++i) {
      const GLfloat size = i % 1000 == 999 ? 0.1F : 0.0F;
      const GLfloat along = 2.0F * static_cast<GLfloat>(i) / triangles - 1.0F;
      glVertex2f(along, along);
      glVertex2f(along + size, along);
      glVertex2f(along, along + size);
    }
    glEnd();
  });
}

TEST_F(FixedFunction, TextureMatricesAndGeneration) {
  GLubyte texels[16][4];
  for (int i = 0; i < 16; ++i) {
    texels[i][0] = static_cast<GLubyte>(i * 16);
    texels[i][1] = static_cast<GLubyte>(255 - i * 12);
    texels[i][2] = static_cast<GLubyte>(i % 4 * 60);
    texels[i][3] = 255;
  }
  for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glRotatef(unit == GL_TEXTURE0 ? 30.0F : 70.0F, 0, 0, 1);
    glScalef(0.7F, 0.6F, 1);
  }
  glEnable(GL_TEXTURE_GEN_S);
  glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  glMatrixMode(GL_MODELVIEW);
  expect_same_scene({4}, [] {
    glBegin(GL_TRIANGLE_STRIP);
    for (const ColoredVertex& vertex : strip().vertices) {
      glMultiTexCoord2f(GL_TEXTURE0, vertex.position[0], vertex.position[1]);
      glMultiTexCoord4f(GL_TEXTURE1, vertex.position[1], vertex.position[0], 0, 1.2F);
      emit(vertex);
    }
    glEnd();
  });
}

TEST_F(FixedFunction, FragmentShaderAlone) {
  const GLuint program = link_program(
      {.fragment = "#version 120\nuniform vec4 tint;\nvoid main() { gl_FragColor = gl_Color.bgra * tint; }\n"});
  glUseProgram(program);
  const GLint tint = glGetUniformLocation(program, "tint");
  expect_same_scene({8}, [tint] {
    glUniform4f(tint, 1, 1, 0.5F, 1);
    draw_immediate(strip());
    glScalef(0.5F, 0.5F, 1);
    glUniform4f(tint, 0.5F, 1, 1, 1);
    draw_immediate(strip());
    glScalef(2, 2, 1);
  });
}

// GL_ATI_fragment_shader reads the texture coordinates without any texture.
TEST_F(FixedFunction, AtiFragmentShader) {
  const auto bind = proc<PFNGLBINDFRAGMENTSHADERATIPROC>("glBindFragmentShaderATI");
  if (bind == nullptr) GTEST_SKIP() << "this GL has no ATI_fragment_shader";
  bind(1);
  proc<PFNGLBEGINFRAGMENTSHADERATIPROC>("glBeginFragmentShaderATI")();
  proc<PFNGLPASSTEXCOORDATIPROC>("glPassTexCoordATI")(GL_REG_1_ATI, GL_TEXTURE0, GL_SWIZZLE_STR_ATI);
  proc<PFNGLCOLORFRAGMENTOP1ATIPROC>("glColorFragmentOp1ATI")(GL_MOV_ATI, GL_REG_0_ATI, GL_NONE, GL_NONE, GL_REG_1_ATI,
                                                              GL_NONE, GL_NONE);
  proc<PFNGLENDFRAGMENTSHADERATIPROC>("glEndFragmentShaderATI")();
  glEnable(GL_FRAGMENT_SHADER_ATI);
  glTexCoord3f(0.25F, 0.75F, 0.5F);
  expect_same_scene({4}, [] { draw_immediate(strip()); });
}

// GL_FIXED_ONLY: a framebuffer of floating-point colours gets them unclamped.
TEST_F(FixedFunction, UnclampedColours) {
  GLuint framebuffer = 0;
  GLuint target = 0;
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(1, &target);
  glBindRenderbuffer(GL_RENDERBUFFER, target);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, picture_size, picture_size);
  glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FIXED_ONLY);
  glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
  refine_uniformly(2);
  glColor4f(7, -2, 0.5F, 0.25F);
  glRectf(-1, -1, 1, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  glBegin(GL_TRIANGLES);
  glVertex2f(-1, -1);
  glVertex2f(3, -1);
  glVertex2f(-1, 3);
  glEnd();
  std::array<GLfloat, 4> color{};
  glReadPixels(picture_size / 2, picture_size / 2, 1, 1, GL_RGBA, GL_FLOAT, color.data());
  EXPECT_EQ(color, (std::array<GLfloat, 4>{7, -2, 0.5F, 0.25F}));
}

TEST_F(FixedFunction, ClipPlaneFogAndStateChangesBetweenDraws) {
  const GLdouble plane[] = {1, 0.5, 0, 0.2};
  glClipPlane(GL_CLIP_PLANE0, plane);
  glFogf(GL_FOG_DENSITY, 0.8F);
  expect_same_scene({12}, [] {
    glEnable(GL_CLIP_PLANE0);
    draw_immediate(strip());
    glDisable(GL_CLIP_PLANE0);
    glScalef(0.6F, 0.6F, 1);
    glTranslatef(0, 0, -0.8F);
    glEnable(GL_FOG);
    draw_immediate(strip());
    glDisable(GL_FOG);
    glLoadIdentity();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glScalef(0.3F, 0.3F, 1);
    draw_immediate(strip());
    glPopAttrib();
    glLoadIdentity();
  });
}

}  // namespace
}  // namespace glark::core::test
