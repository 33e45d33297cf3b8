// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glMaterial between glBegin and glEnd: each vertex of the fixed function has its own material; a vertex shader has the
// one from before glBegin.
#include <array>
#include <climits>
#include <functional>
#include <tuple>

#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

// With the ambient light they stay below 1: GL clamps at the vertices, and there are more of them in refined draws.
constexpr GLfloat colors[3][4] = {{0.9F, 0.25F, 0, 1}, {0, 0.9F, 0.25F, 1}, {0.25F, 0, 0.9F, 1}};

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
  enum class Becomes { refined, unrefined };
  static void expect_same_picture(const std::function<void()>& draw, Becomes becomes = Becomes::refined) {
    glDisable(GL_ARK);
    const Picture plain = picture_of(draw);
    const GLuint coarse = generated_primitives;
    refine_uniformly(2);
    picture_of(draw);  // the first strip shows that there are such strips
    EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
    EXPECT_EQ(generated_primitives, becomes == Becomes::refined ? coarse << 4U : coarse);
    EXPECT_EQ(pending_errors(), "");
  }
  static void light() {
    constexpr GLfloat behind[] = {0.3F, 0.5F, 1, 0};
    glLightfv(GL_LIGHT0, GL_POSITION, behind);
    glEnable(GL_LIGHT0);
    glNormal3f(0, 0, 1);
  }
  static std::array<GLfloat, 4> attribute(GLuint index) {
    std::array<GLfloat, 4> value{};
    glGetVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, value.data());
    return value;
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

// A strip in which one parameter changes, with a light. Mesa 22 itself draws nonsense if parameters of the back face
// change, so only its emission is compared.
class MaterialParameter : public Materials, public testing::WithParamInterface<std::tuple<GLenum, GLenum>> {};

TEST_P(MaterialParameter, OfEachVertexOfAStrip) {
  const auto [face, name] = GetParam();
  constexpr GLfloat dark[] = {0.2F, 0.2F, 0.2F, 1};  // no sum exceeds 1
  light();
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, face == GL_BACK ? 1 : 0);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, dark);
  expect_same_picture([face = face, name = name] {
    for (const int turned : {0, 1}) {
      glFrontFace(turned != 0 ? GL_CW : GL_CCW);
      glBegin(GL_TRIANGLE_STRIP);
      for (int i = 0; i < 6; ++i) {
        const GLfloat half[] = {colors[i / 2][0] / 2, colors[i / 2][1] / 2, colors[i / 2][2] / 2, 1};
        glMaterialfv(face, name, half);
        glVertex3f(zigzag[i].position[0] / 2 + static_cast<float>(turned) / 2 - 0.25F, zigzag[i].position[1], 0);
      }
      glEnd();
    }
    glFrontFace(GL_CCW);
  });
}

INSTANTIATE_TEST_SUITE_P(All, MaterialParameter,
                         testing::Values(std::tuple(GL_FRONT, GL_AMBIENT), std::tuple(GL_FRONT, GL_DIFFUSE),
                                         std::tuple(GL_FRONT, GL_SPECULAR), std::tuple(GL_FRONT, GL_EMISSION),
                                         std::tuple(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE),
                                         std::tuple(GL_BACK, GL_EMISSION)));

// The exponent is interpolated between the vertices, the plain highlight is not.
TEST_F(Materials, ShininessOfEachTriangle) {
  light();
  constexpr GLfloat white[] = {1, 1, 1, 1};
  glMaterialfv(GL_FRONT, GL_SPECULAR, white);
  const auto draw = [] {
    for (int i = 0; i < 2; ++i) {
      glBegin(GL_TRIANGLE_STRIP);
      for (const int corner : {0, 1, 2}) {
        glMateriali(GL_FRONT, GL_SHININESS, 1 + 60 * i);
        vertex(3 * i + corner);
      }
      glEnd();
    }
  };
  expect_same_picture(draw);
}

TEST_F(Materials, IntegersAreNormalised) {
  expect_same_picture([] {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 6; ++i) {
      const GLint color[] = {i % 2 != 0 ? 1 << 30 : 1 << 29, 1 << 29, INT_MIN, INT_MAX};
      glMaterialiv(GL_FRONT, GL_EMISSION, color);
      vertex(i);
    }
    glEnd();
  });
}

// The vertices before the first change have the material from before glBegin.
TEST_F(Materials, InheritedByTheFirstVertices) {
  expect_same_picture([] {
    set_material(1);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 6; ++i) {
      if (i == 3) set_material(2);
      vertex(i);
    }
    glEnd();
  });
}

TEST_F(Materials, LeaveTheAttributesOfTheApplication) {
  for (GLuint index = 1; index < 15; ++index) {
    glVertexAttrib4f(index, static_cast<GLfloat>(index), 2, 3, 4);
  }
  refine_uniformly(2);
  const GLuint list = compile(strip);
  for (int frame = 0; frame < 3; ++frame) {
    strip();
    glCallList(list);
    for (GLuint index = 1; index < 15; ++index) {
      EXPECT_EQ(attribute(index), (std::array<GLfloat, 4>{static_cast<GLfloat>(index), 2, 3, 4})) << index;
    }
  }
  std::array<GLfloat, 4> emission{};
  glGetMaterialfv(GL_FRONT, GL_EMISSION, emission.data());
  EXPECT_EQ(emission[2], colors[2][2]);
}

TEST_F(Materials, OfAList) {
  const GLuint list = compile(strip);
  expect_same_picture([list] { glCallList(list); });
  const GLuint other = compile(triangles);
  expect_same_picture([other] { glCallList(other); });
}

// The list does not say which material its first vertices have.
TEST_F(Materials, OfAListThatInheritsOneStaysUnrefined) {
  const GLuint list = compile([] {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 6; ++i) {
      if (i == 3) set_material(2);
      vertex(i);
    }
    glEnd();
  });
  const auto draw = [list] {
    set_material(0);
    glCallList(list);
  };
  expect_same_picture(draw, Becomes::unrefined);
}

TEST_F(Materials, AVertexShaderSeesThemAfterwards) {
  glUseProgram(link_program({.vertex = "#version 120\nvoid main() { gl_Position = ftransform(); gl_FrontColor = "
                                       "gl_FrontMaterial.emission; }\n"}));
  expect_same_scene({6}, [] {
    strip();
    triangles();
  });
  const GLuint list = compile(strip);
  expect_same_picture([list] { glCallList(list); }, Becomes::unrefined);
}

}  // namespace
}  // namespace glark::core::test
