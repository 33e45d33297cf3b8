// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A refined draw leaves the state that the same unrefined draw leaves.
//
// Plan: with unusual state of the application bound, compare every queryable value before and after a draw. Values that
// the unrefined draw changes too (the current colour of glBegin) are left out. Proof of life: the draw gives 4^level
// triangles.
#include "tests/core/support/modes.h"
#include "tests/core/support/programs.h"
#include "tests/core/support/scene.h"
#include "tests/core/support/state_snapshot.h"

namespace glark::core::test {
namespace {

const char* const old_vertex =
    "#version 120\nuniform mat4 m;\nvoid main() { gl_Position = m * gl_Vertex; gl_FrontColor = gl_Color; }\n";
const char* const new_vertex =
    "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color; out vec3 c;\n"
    "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n";
const char* const new_fragment = "#version 430\nin vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n";

const ModeShape& strip() { return mode_shapes()[1]; }

class StateAfterDraws : public testing::TestWithParam<Profile> {
 protected:
  StateAfterDraws() {
    glARKinit(2);
    names_ = StateSnapshot::find_names();
    EXPECT_EQ(pending_errors(), "");
  }
  bool core() const { return GetParam() == Profile::core; }

  void make_objects_of_the_application() {
    for (GLuint i = 0; i < 6; ++i) {
      const GLuint buffer = make_buffer(GL_SHADER_STORAGE_BUFFER, std::vector<GLubyte>(4096));
      if (i % 2 == 0) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffer);
      } else {
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, i, buffer, 256 * i, 128);
      }
      glBindBufferRange(GL_UNIFORM_BUFFER, i, buffer, 256, 64);
      glBindBufferBase(GL_ATOMIC_COUNTER_BUFFER, i % 4, buffer);
    }
    make_buffer(GL_SHADER_STORAGE_BUFFER, std::vector<GLubyte>(64));
    for (const GLenum target : {GL_DRAW_INDIRECT_BUFFER, GL_QUERY_BUFFER, GL_DISPATCH_INDIRECT_BUFFER,
                                GL_PARAMETER_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_TEXTURE_BUFFER}) {
      make_buffer(target, std::vector<GLubyte>(1024));
    }
    pending_errors();  // GL_PARAMETER_BUFFER is of OpenGL 4.6
    GLuint feedback = 0;
    glGenTransformFeedbacks(1, &feedback);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
    for (GLuint i = 0; i < 2; ++i) {
      glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, i, make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>(1024)), 64,
                        256);
    }
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>(16)));
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }
  void set_unusual_modes() {
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(12345);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glEnable(GL_POLYGON_OFFSET_LINE);
    glActiveTexture(GL_TEXTURE3);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    for (GLuint i = 2; i < 14; ++i) glVertexAttrib4f(i, 0.1F, 0.2F, 0.3F, static_cast<GLfloat>(i));
    if (core()) return;
    glClientActiveTexture(GL_TEXTURE2);
    glMatrixMode(GL_TEXTURE);
    glPushMatrix();
    glRotatef(20, 1, 2, 3);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glScalef(0.9F, 0.9F, 1);
    glNormal3f(0.1F, 0.2F, 0.3F);
    glSecondaryColor3f(0.3F, 0.2F, 0.1F);
    glEnable(GL_LIGHT3);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  }

  template <typename Draw>
  void expect_state_kept(GLuint triangles, Draw&& draw) {
    make_objects_of_the_application();
    set_unusual_modes();
    ASSERT_EQ(pending_errors(), "");
    const StateSnapshot before_plain = StateSnapshot::take(names_);
    ASSERT_GT(before_plain.size(), 1000U);
    draw();
    const std::vector<std::string> own = StateSnapshot::take(names_).differing_names(before_plain);
    EXPECT_LT(own.size(), 12U);
    glEnable(GL_ARK);
    for (int repetition = 0; repetition < 3; ++repetition) {
      const StateSnapshot before = StateSnapshot::take(names_);
      draw();
      EXPECT_EQ(pending_errors(), "");
      EXPECT_EQ(before.difference(StateSnapshot::take(names_), own), "") << "repetition " << repetition;
    }
    // The application's pending error survives the draw, and no other error appears.
    glDisable(GL_ARK);
    glEnable(GL_ARK);
    glEnable(0xFFFF);
    draw();
    EXPECT_EQ(pending_errors(), "0x0500 ");
    glBindBuffer(GL_QUERY_BUFFER, 0);
    picture_of(draw);
    EXPECT_GE(generated_primitives, triangles);
  }
  void use_new_program() {
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    make_buffer(GL_ARRAY_BUFFER, strip().vertices);
    point_generic_arrays(nullptr);
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLushort>{0, 1, 2, 3, 12345, 2, 3, 4, 5});
    glUseProgram(link_program({.vertex = new_vertex, .fragment = new_fragment}));
  }
  void set_uniform_depth() {
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
    glARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  }
  OsmesaContext context_{GetParam()};
  StateSnapshot::Names names_;
};

class StateAfterDrawsCompatibility : public StateAfterDraws {};

INSTANTIATE_TEST_SUITE_P(All, StateAfterDraws, testing::Values(Profile::compatibility, Profile::core), profile_name);
INSTANTIATE_TEST_SUITE_P(All, StateAfterDrawsCompatibility, testing::Values(Profile::compatibility), profile_name);

TEST_P(StateAfterDraws, UniformDepthFromABuffer) {
  set_uniform_depth();
  use_new_program();
  expect_state_kept(4 * 16, [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
}

TEST_P(StateAfterDraws, AdaptiveTagsFromAnArray) {
  use_new_program();
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2, 2, 1, 0});
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_state_kept(10, [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
}

TEST_P(StateAfterDraws, MeasuredDepths) {
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  glARKParameteriARK(GL_TRIANGLE_BUDGET_ARK, 1000);
  use_new_program();
  expect_state_kept(10, [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
}

TEST_P(StateAfterDraws, Restart) {
  set_uniform_depth();
  use_new_program();
  expect_state_kept(4 * 16, [] { glDrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_SHORT, nullptr); });
}

TEST_P(StateAfterDraws, AdaptiveRestart) {
  use_new_program();
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2, 2, 1, 0});
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_state_kept(10, [] { glDrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_SHORT, nullptr); });
}

TEST_P(StateAfterDraws, Indirect) {
  set_uniform_depth();
  use_new_program();
  const GLuint commands = make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>{6, 2, 0, 0});
  expect_state_kept(8 * 16, [commands] {
    GLint bound = 0;
    GLint parameters = 0;
    glGetIntegerv(GL_DRAW_INDIRECT_BUFFER_BINDING, &bound);
    glGetIntegerv(GL_PARAMETER_BUFFER_BINDING, &parameters);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands);
    glBindBuffer(GL_PARAMETER_BUFFER, 0);  // Mesa would take the number of commands from it
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, static_cast<GLuint>(bound));
    glBindBuffer(GL_PARAMETER_BUFFER, static_cast<GLuint>(parameters));
  });
}

TEST_P(StateAfterDraws, DrawArp) {
  set_uniform_depth();
  use_new_program();
  expect_state_kept(4 * 16, [] { glDrawARP(GL_TRIANGLE_STRIP, 0, 6); });
}

TEST_P(StateAfterDrawsCompatibility, Immediate) {
  set_uniform_depth();
  expect_state_kept(4 * 16, [] { draw_immediate(strip()); });
}

TEST_P(StateAfterDrawsCompatibility, ImmediateMeasured) {
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  expect_state_kept(10, [] { draw_immediate(strip()); });
}

TEST_P(StateAfterDrawsCompatibility, ImmediateTags) {
  expect_state_kept(4 * 16, [] {
    glDepthTag1i(2);
    draw_immediate(strip());
  });
}

TEST_P(StateAfterDrawsCompatibility, ImmediateTagsThatVary) {
  expect_state_kept(10, [] {
    glBegin(GL_TRIANGLE_STRIP);
    for (GLuint i = 0; i < 6; ++i) {
      glDepthTag1i(i % 3);
      emit(strip().vertices[i]);
    }
    glEnd();
  });
}

TEST_P(StateAfterDrawsCompatibility, ImmediateLit) {
  set_uniform_depth();
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_COLOR_MATERIAL);
  expect_state_kept(4 * 16, [] { draw_immediate(strip()); });
}

TEST_P(StateAfterDrawsCompatibility, ClientArrays) {
  set_uniform_depth();
  point_conventional_arrays(strip().vertices.data());
  expect_state_kept(4 * 16, [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
}

TEST_P(StateAfterDrawsCompatibility, BufferAndOldProgram) {
  set_uniform_depth();
  make_buffer(GL_ARRAY_BUFFER, strip().vertices);
  point_conventional_arrays(nullptr);
  const GLuint program = link_program({.vertex = old_vertex});
  glUseProgram(program);
  const GLfloat identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  glUniformMatrix4fv(glGetUniformLocation(program, "m"), 1, GL_FALSE, identity);
  expect_state_kept(4 * 16, [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 6); });
}

TEST_P(StateAfterDrawsCompatibility, DisplayList) {
  set_uniform_depth();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw_immediate(strip());
  glRectf(-1, -1, 1, 1);
  glEndList();
  expect_state_kept(4 * 16 + 1, [list] { glCallList(list); });
}

// The control: the snapshot sees each of these.
TEST_P(StateAfterDraws, SnapshotSeesChanges) {
  const auto changes = [this](auto&& change) {
    const StateSnapshot before = StateSnapshot::take(names_);
    change();
    return !before.differing_names(StateSnapshot::take(names_)).empty();
  };
  EXPECT_FALSE(changes([] {}));
  EXPECT_TRUE(changes([] { make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLubyte>(16)); }));
  EXPECT_TRUE(changes([] { make_buffer(GL_QUERY_BUFFER, std::vector<GLubyte>(16)); }));
  EXPECT_TRUE(changes([] {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, make_buffer(GL_SHADER_STORAGE_BUFFER, std::vector<GLubyte>(16)));
  }));
  EXPECT_TRUE(changes([] { glVertexAttrib4f(7, 1, 2, 3, 4); }));
  EXPECT_TRUE(changes([] { glEnable(GL_RASTERIZER_DISCARD); }));
  EXPECT_TRUE(changes([] { glPrimitiveRestartIndex(77); }));
}

}  // namespace
}  // namespace glark::core::test
