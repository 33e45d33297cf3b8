// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that repeat are drawn from kept refined vertices, by the application's own program. Their picture stays that of
// the first refined draw, whatever the application changes between two draws.
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "tests/core/evaluate/kept_pictures.h"
#include "tests/core/meshes/ball.h"
#include "tests/core/support/kept_scene.h"
#include "tests/core/support/state_snapshot.h"

namespace glark::core::test {
namespace {

// After `change`, the picture equals the unrefined one: nothing is drawn that was kept before.
void expect_change_seen(const std::function<void()>& draw, const std::function<void()>& change) {
  expect_same_picture(draw);
  change();
  const Picture changed = expect_same_picture(draw);
  glDisable(GL_ARK);
  EXPECT_LE(differing_pixels(picture_of(draw), changed), tolerated_pixels);
  glEnable(GL_ARK);
}

class KeptVertices : public KeptScene {};

INSTANTIATE_TEST_SUITE_P(All, KeptVertices, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(KeptVertices, EveryLevel) {
  for (const GLuint level : {1U, 2U, 3U, 5U, 2U}) {
    refine_uniformly(level, GL_LINEAR_INPUTS_ARK);
    expect_same_picture(draw_elements);
    expect_same_picture(draw_arrays);
  }
}

// Pools of other levels have their patterns in other places.
TEST_P(KeptVertices, PoolsOfOtherLevels) {
  for (const GLuint pool : {11U, 6U, 3U, 11U}) {
    const std::vector<ColoredVertex> vertices = pool == 11 ? one() : two();
    glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, vertices.data());  // drops what is kept
    glDisable(GL_ARK);
    const Picture plain = picture_of(draw_elements);
    refine_uniformly(3, GL_LINEAR_INPUTS_ARK);
    glARKinit(pool);
    EXPECT_LE(differing_pixels(expect_same_picture(draw_elements), plain), tolerated_pixels) << "pool " << pool;
  }
}

// While a feedback is paused, the program draws what was captured so far.
TEST_P(KeptVertices, BufferOfAPausedFeedback) {
  refine_uniformly(1, GL_LINEAR_INPUTS_ARK);
  const GLuint program = link_program(
      {.vertex = "#version 430\nlayout(location = 0) in vec2 position; uniform vec2 place; out vec2 captured;\n"
                 "void main() { captured = 0.4 * position + place; gl_Position = vec4(position, 0.0, 1.0); }\n",
       .fragment = "#version 430\nout vec4 result;\nvoid main() { result = vec4(1.0); }\n",
       .varyings = {"captured"}});
  constexpr GLsizei captured_vertices = 24;  // of two refined draws of a triangle
  const GLuint buffer = make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, std::vector<GLfloat>(2 * captured_vertices));
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  float_attribute(0, 2);
  const auto draw_captured = [] { glDrawArrays(GL_TRIANGLES, 0, captured_vertices); };
  glUseProgram(program);
  glBindVertexArray(array_);
  glBeginTransformFeedback(GL_TRIANGLES);
  std::vector<Picture> pictures;
  for (const GLfloat place : {-0.5F, 0.5F}) {
    glUniform2f(glGetUniformLocation(program, "place"), place, 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glPauseTransformFeedback();
    glBindVertexArray(array);
    repeat_often(draw_captured);
    glClear(GL_COLOR_BUFFER_BIT);
    draw_captured();
    pictures.push_back(read_picture());
    glBindVertexArray(array_);
    glResumeTransformFeedback();
  }
  glEndTransformFeedback();
  EXPECT_GT(differing_pixels(pictures[0], pictures[1]), visible_pixels) << "what was captured later is missing";
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(KeptVertices, UniformsOfTheApplication) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const GLuint program = link_program(
      {.vertex = "#version 430\nlayout(location = 0) in vec2 p; layout(location = 1) in vec3 color; out vec3 c;\n"
                 "uniform float scale = 1.0; void main() { gl_Position = vec4(scale * p, 0.0, 1.0); c = color; }\n",
       .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
  glUseProgram(program);
  const Picture whole = expect_same_picture(draw_elements);
  glUniform1f(glGetUniformLocation(program, "scale"), 0.5F);
  EXPECT_GT(differing_pixels(whole, expect_same_picture(draw_elements)), visible_pixels);
}

TEST_P(KeptVertices, TwoProgramsWithTheSameInputs) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const GLuint other = link_program(
      {.vertex =
           "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; out vec3 c;\n"
           "void main() { gl_Position = vec4(0.5 * position, 0.0, 1.0); c = color.zxy; }\n",
       .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
  expect_same_picture([&] {
    glUseProgram(program_);
    draw_elements();
    glUseProgram(other);
    draw_elements();
  });
}

TEST_P(KeptVertices, MatricesAndArraysAsAttributes) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const GLuint program = link_program(
      {.vertex =
           "#version 430\nlayout(location = 0) in vec2 p; layout(location = 2) in mat3x2 m; "
           "layout(location = 6) in float a[2]; out vec3 c;\n"
           "void main() { gl_Position = vec4(p + 0.1 * m[1], 0.0, 1.0); c = vec3(m[0].x, a[0], a[1] + m[2].y); }\n",
       .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
  glUseProgram(program);
  for (const GLuint location : {2U, 3U, 4U, 6U, 7U}) {
    glVertexAttribPointer(location, location < 5 ? 2 : 1, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex),
                          byte_offset(4 + 4 * (location % 3)));
    glEnableVertexAttribArray(location);
  }
  expect_same_picture(draw_elements);
}

TEST_P(KeptVertices, InstancesByDivisors) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const GLuint program = link_program(
      {.vertex =
           "#version 430\nlayout(location = 0) in vec2 p; layout(location = 1) in vec3 color; layout(location = 2) "
           "in vec2 offset; out vec3 c;\n"
           "void main() { gl_Position = vec4(0.4 * p + offset, 0.0, 1.0); c = color; }\n",
       .fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
  glUseProgram(program);
  const GLuint offsets = make_buffer(GL_ARRAY_BUFFER, std::vector<GLfloat>{-0.5F, -0.5F, 0.5F, 0.5F});
  float_attribute(2, 2);
  glVertexAttribDivisor(2, 1);
  const auto draw = [] { glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 6, 2); };
  expect_same_picture(draw);
  expect_change_seen(draw, [&] {
    const std::array<GLfloat, 4> moved{-0.5F, 0.5F, 0.5F, -0.5F};
    glBindBuffer(GL_ARRAY_BUFFER, offsets);
    glBufferSubData(GL_ARRAY_BUFFER, 0, sizeof(moved), moved.data());
  });
}

// The value of a `flat` output is that of the provoking corner of the coarse triangle.
TEST_P(KeptVertices, FlatOutputs) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const GLuint program = link_program(
      {.vertex =
           "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; flat out vec3 c;\n"
           "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n",
       .fragment = "#version 430\nflat in vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n"});
  glUseProgram(program);
  expect_same_picture(draw_elements);
}

TEST_P(KeptVertices, RestartDoesNotApplyToTheirIndices) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(7);
  expect_same_picture(draw_arrays);
  EXPECT_EQ(glIsEnabled(GL_PRIMITIVE_RESTART), GL_TRUE);
}

TEST_P(KeptVertices, TheStateOfTheApplicationStays) {
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const StateSnapshot::Names names = StateSnapshot::find_names();
  EXPECT_NE(pending_errors(), "no errors of unknown names");
  draw_elements();
  const StateSnapshot before = StateSnapshot::take(names);
  repeat_often(draw_elements);
  EXPECT_EQ(StateSnapshot::take(names).difference(before), "");
}

TEST_P(KeptVertices, RefinementsTakeTurns) {
  const auto draw = [] {
    refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
    draw_arrays();
    refine_uniformly(3, GL_LINEAR_OUTPUTS_ARK);
    draw_elements();
  };
  expect_same_picture(draw);
}

// The same arrays are drawn as PN triangles, as Phong tessellation of two shapes, and flat.
TEST(KeptCurvedVertices, ShapesTakeTurns) {
  const OsmesaContext context(Profile::compatibility);
  const Ball ball(Source::buffer);
  std::vector<Picture> pictures;
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  for (int round = 0; round < 2; ++round) {
    for (const GLfloat shape : {1.0F, 0.25F, 0.0F}) {
      refine_uniformly(3, GL_PHONG_ARK);
      glARKParameterfARK(GL_PHONG_SHAPE_ARK, shape);
      pictures.push_back(expect_same_picture([&] { ball.draw(); }));
    }
    refine_uniformly(3, GL_CURVED_PN_ARK);
    pictures.push_back(expect_same_picture([&] { ball.draw(); }));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(differing_pixels(pictures[i], pictures[i + 4]), 0) << i;
    for (std::size_t other = 0; other < i; ++other) {
      EXPECT_GT(differing_pixels(pictures[i], pictures[other]), 100) << i << " and " << other;
    }
  }
}

// One pass is kept and drawn by the application's fixed function; the other one has a flat output, so that it cannot be
// kept. Both have the same depth to the bit.
TEST(KeptCurvedVertices, MeetPassesThatCannotBeKept) {
  const OsmesaContext context(Profile::compatibility);
  const Ball ball(Source::buffer);
  const GLuint flat = link_program(
      {.vertex = "#version 130\nflat out vec4 c; void main() { c = vec4(0.0, 1.0, 0.001 * abs(gl_Normal.x), 1.0); "
                 "gl_Position = ftransform(); }",
       .fragment = "#version 130\nflat in vec4 c; void main() { gl_FragColor = c; }"});
  refine_uniformly(4, GL_CURVED_PN_ARK);
  glEnable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.3, 0.3, -0.3, 0.3, 0.5, 5);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0.01F, -0.02F, -1.9F);
  glRotatef(33, 0.3F, 1, 0.2F);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  const std::array<GLfloat, 4> red{1, 0, 0, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, red.data());
  const std::array<GLfloat, 4> white{1, 1, 1, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, white.data());
  const auto draw = [&] {
    glDepthFunc(GL_LESS);
    glUseProgram(0);
    ball.draw();
    glDepthFunc(GL_EQUAL);
    glUseProgram(flat);
    ball.draw();
    glDepthFunc(GL_LESS);
  };
  EXPECT_EQ(red_pixels(expect_same_picture(draw)), 0);
}

TEST(KeptFixedFunction, LightTexturesFogAndSecondaryColors) {
  const OsmesaContext context(Profile::compatibility);
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  struct Vertex {
    std::array<GLfloat, 3> position, normal, color, secondary;
    GLfloat fog;
    std::array<GLfloat, 2> texture;
  };
  std::vector<Vertex> vertices;
  for (const ColoredVertex& v : first_vertices()) {
    const auto [x, y] = v.position;
    vertices.push_back(
        {{x, y, 0.1F * x}, {0.3F * x, 0.3F * y, 1}, v.color, {0, 0.3F * x * x, 0.2F}, 0.5F + 0.4F * y, {x, y}});
  }
  make_buffer(GL_ARRAY_BUFFER, vertices);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), byte_offset(0));
  glNormalPointer(GL_FLOAT, sizeof(Vertex), byte_offset(12));
  glColorPointer(3, GL_FLOAT, sizeof(Vertex), byte_offset(24));
  glSecondaryColorPointer(3, GL_FLOAT, sizeof(Vertex), byte_offset(36));
  glFogCoordPointer(GL_FLOAT, sizeof(Vertex), byte_offset(48));
  glClientActiveTexture(GL_TEXTURE1);
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), byte_offset(52));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE2);
  for (const GLenum array :
       {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY}) {
    glEnableClientState(array);
  }
  glActiveTexture(GL_TEXTURE1);
  const std::array<GLubyte, 16> texels{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_FOG);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glEnable(GL_COLOR_SUM);
  expect_same_picture([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  expect_same_picture([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
  glShadeModel(GL_FLAT);
  expect_same_picture([] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
  GLint unit = 0;
  glGetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &unit);
  EXPECT_EQ(unit, GL_TEXTURE2);
}

TEST(KeptFixedFunction, CurrentColorsAndLists) {
  const OsmesaContext context(Profile::compatibility);
  refine_uniformly(2, GL_LINEAR_INPUTS_ARK);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLE_STRIP);
  for (const ColoredVertex& vertex : first_vertices()) glVertex2fv(vertex.position.data());
  glEnd();
  glEndList();
  glColor3f(1, 0, 0);
  const auto draw = [list] { glCallList(list); };
  expect_change_seen(draw, [] { glColor3f(0, 1, 0); });
  expect_change_seen(draw, [] { glScalef(0.5F, 0.5F, 1); });
}

}  // namespace
}  // namespace glark::core::test
