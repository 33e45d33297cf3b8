// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glMaterial between glBegin and glEnd: each vertex of the fixed function has its own material; a vertex shader has the
// one from before glBegin.
#include <functional>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

constexpr GLfloat colors[3][4] = {{1, 0.25F, 0, 1}, {0, 1, 0.25F, 1}, {0.25F, 0, 1, 1}};

void set_material(int i) { glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, colors[i]); }

class Materials : public testing::Test {
 protected:
  Materials() {
    glEnable(GL_LIGHTING);
    glARKinit(2);
  }
  static void vertex(int i) { glVertex2fv(zigzag[i].position.data()); }
  // Two triangles of different materials.
  static void triangles() {
    set_material(2);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 2; ++i) {
      set_material(i);
      for (const int corner : {0, 1, 2}) vertex(3 * i + corner);
    }
    glEnd();
  }
  static void strip() {
    set_material(2);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 6; ++i) {
      set_material(i / 2);
      vertex(i);
    }
    glEnd();
  }
  template <typename Contents>
  static GLuint compile(Contents&& contents) {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    contents();
    glEndList();
    return list;
  }
  static void expect_same_picture(const std::function<void()>& draw) {
    glDisable(GL_ARK);
    const Picture plain = picture_of(draw);
    refine_uniformly(2);
    picture_of(draw);  // the first strip shows that there are such strips
    EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
    EXPECT_EQ(pending_errors(), "");
  }

  OsmesaContext context_{Profile::compatibility};
};

TEST_F(Materials, OfEachTriangle) { expect_same_scene({2}, triangles); }

TEST_F(Materials, BeforeTheFirstVertexOfAStrip) {
  expect_same_scene({4}, [] {
    set_material(0);
    glBegin(GL_TRIANGLE_STRIP);
    set_material(1);
    for (int i = 0; i < 6; ++i) vertex(i);
    glEnd();
  });
}

TEST_F(Materials, OfEachVertexOfAStrip) { expect_same_picture(strip); }

TEST_F(Materials, OfAList) {
  const GLuint list = compile(strip);
  expect_same_picture([list] { glCallList(list); });
  const GLuint other = compile(triangles);
  expect_same_picture([other] { glCallList(other); });
}

TEST_F(Materials, AVertexShaderSeesThemAfterwards) {
  glUseProgram(link_program({.vertex = "#version 120\nvoid main() { gl_Position = ftransform(); gl_FrontColor = "
                                       "gl_FrontMaterial.emission; }\n"}));
  expect_same_scene({6}, [] {
    strip();
    triangles();
  });
  const GLuint list = compile(strip);
  expect_same_picture([list] { glCallList(list); });
}

}  // namespace
}  // namespace glark::core::test
