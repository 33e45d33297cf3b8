// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Subroutines, separate programs in pipelines, and links that fail.
#include "tests/core/support/program_scene.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

class ProgramStages : public ProgramScene {
 protected:
  static void choose(GLuint program, GLenum stage, const char* name) {
    const auto index_of = proc<PFNGLGETSUBROUTINEINDEXPROC>("glGetSubroutineIndex");
    const auto choose = proc<PFNGLUNIFORMSUBROUTINESUIVPROC>("glUniformSubroutinesuiv");
    const GLuint index = index_of(program, stage, name);
    choose(stage, 1, &index);
  }
};

INSTANTIATE_TEST_SUITE_P(All, ProgramStages, testing::Values(Profile::compatibility, Profile::core), profile_name);

const std::string fragment_subroutines =
    "#version 430\nin vec3 c; out vec4 result;\nsubroutine vec3 tint();\n"
    "subroutine(tint) vec3 dark() { return vec3(0.0); }\nsubroutine(tint) vec3 plain() { return c; }\n"
    "subroutine(tint) vec3 inverse() { return 1.0 - c; }\n"
    "subroutine uniform tint chosen;\nvoid main() { result = vec4(chosen(), 1.0); }\n";
const std::string vertex_subroutines =
    "subroutine vec3 look(vec3 c);\nsubroutine(look) vec3 same(vec3 c) { return c; }\n"
    "subroutine(look) vec3 turned(vec3 c) { return c.brg; }\nsubroutine uniform look chosen_look;\n";

// The choice of subroutines is lost when another program is used.
TEST_P(ProgramStages, SubroutinesOfTheFragmentStageStayChosen) {
  const GLuint program = use("out vec3 c;\n", "", fragment_subroutines);
  choose(program, GL_FRAGMENT_SHADER, "plain");
  expect_same_scene({4}, draw);
  expect_same_scene({8}, [&] {
    glViewport(0, 0, picture_size / 2, picture_size);
    choose(program, GL_FRAGMENT_SHADER, "inverse");
    draw();
    glViewport(picture_size / 2, 0, picture_size / 2, picture_size);
    choose(program, GL_FRAGMENT_SHADER, "plain");
    draw();
    glViewport(0, 0, picture_size, picture_size);
  });
}

TEST_P(ProgramStages, SubroutinesOfTheVertexStage) {
  const GLuint program = use(vertex_subroutines + "out vec3 c;\n", "c = chosen_look(c);\n", fragment_subroutines);
  choose(program, GL_FRAGMENT_SHADER, "plain");
  for (const char* name : {"turned", "same"}) {
    choose(program, GL_VERTEX_SHADER, name);
    expect_same_scene({4}, draw);
    expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
  }
}

const char* const separate_vertex =
    "#version 430\nlayout(location = 0) in vec2 position; layout(location = 1) in vec3 color;\n"
    "out gl_PerVertex { vec4 gl_Position; }; layout(location = 0) out vec3 c; uniform vec2 shift; uniform float size = "
    "1.0;\nvoid main() { gl_Position = vec4(position * size + shift, 0.0, 1.0); c = color; }\n";
const char* const separate_fragment =
    "#version 430\nlayout(location = 0) in vec3 c; out vec4 result; uniform vec3 tint = vec3(1.0);\n"
    "void main() { result = vec4(c * tint, 1.0); }\n";

class ProgramPipelines : public ProgramStages {
 protected:
  ProgramPipelines() {
    vertex_ = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &separate_vertex);
    fragment_ = glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &separate_fragment);
    glGenProgramPipelines(1, &pipeline_);
    glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, vertex_);
    glUseProgramStages(pipeline_, GL_FRAGMENT_SHADER_BIT, fragment_);
    glBindProgramPipeline(pipeline_);
  }
  GLuint vertex_ = 0;
  GLuint fragment_ = 0;
  GLuint pipeline_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, ProgramPipelines, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(ProgramPipelines, SeparateStages) {
  expect_same_scene({4}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
  GLint bound = 0;
  glGetIntegerv(GL_PROGRAM_PIPELINE_BINDING, &bound);
  EXPECT_EQ(static_cast<GLuint>(bound), pipeline_);
}

TEST_P(ProgramPipelines, UniformsByEitherWay) {
  const GLint size = glGetUniformLocation(vertex_, "size");
  const GLint shift = glGetUniformLocation(vertex_, "shift");
  glActiveShaderProgram(pipeline_, vertex_);
  expect_same_scene({12}, [&] {
    for (int i = 0; i < 3; ++i) {
      glProgramUniform1f(vertex_, size, 0.3F);
      glUniform2f(shift, 0.6F * static_cast<GLfloat>(i - 1), 0.1F);
      glProgramUniform3f(fragment_, glGetUniformLocation(fragment_, "tint"), 1.0F, 0.5F * static_cast<GLfloat>(i),
                         1.0F);
      draw();
    }
  });
}

TEST_P(ProgramPipelines, StagesExchangedAndSharedBetweenPipelines) {
  const char* const inverse =
      "#version 430\nlayout(location = 0) in vec3 c; out vec4 result;\nvoid main() { result = vec4(1.0 - c, 1.0); }\n";
  const GLuint other = glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &inverse);
  GLuint second = 0;
  glGenProgramPipelines(1, &second);
  glUseProgramStages(second, GL_VERTEX_SHADER_BIT, vertex_);
  glUseProgramStages(second, GL_FRAGMENT_SHADER_BIT, other);
  expect_same_scene({8}, [&] {
    glViewport(0, 0, picture_size / 2, picture_size);
    glBindProgramPipeline(pipeline_);
    draw();
    glViewport(picture_size / 2, 0, picture_size / 2, picture_size);
    glBindProgramPipeline(second);
    draw();
    glViewport(0, 0, picture_size, picture_size);
  });
  glBindProgramPipeline(pipeline_);
  glUseProgramStages(pipeline_, GL_FRAGMENT_SHADER_BIT, other);
  expect_same_scene({4}, draw);
  glDeleteProgramPipelines(1, &second);
  expect_same_scene({4}, draw);
}

TEST_P(ProgramPipelines, AProgramInUseHidesThePipeline) {
  expect_same_scene({4}, draw);
  const GLuint program = use("out vec3 c;\n", "c = 1.0 - c;\n");
  expect_same_scene({4}, draw);
  glUseProgram(0);
  glDeleteProgram(program);
  expect_same_scene({4}, draw);
}

TEST_P(ProgramPipelines, RelinkedStage) {
  const GLuint program = glCreateProgram();
  glProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  attach_shader(program, GL_VERTEX_SHADER, separate_vertex);
  glLinkProgram(program);
  glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, program);
  expect_same_scene({4}, draw);
  GLuint shader = 0;
  glGetAttachedShaders(program, 1, nullptr, &shader);
  std::string source = separate_vertex;
  source.insert(source.rfind('}'), "c = color.brg; ");
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glLinkProgram(program);
  expect_same_scene({4}, draw);
}

TEST_P(ProgramPipelines, Subroutines) {
  std::string source = fragment_subroutines;
  source.insert(source.find("in vec3 c"), "layout(location = 0) ");
  const char* const text = source.c_str();
  const GLuint fragment = glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &text);
  glUseProgramStages(pipeline_, GL_FRAGMENT_SHADER_BIT, fragment);
  choose(fragment, GL_FRAGMENT_SHADER, "inverse");
  expect_same_scene({4}, draw);
}

TEST_P(ProgramPipelines, DeletedProgramsAndNoVertexStage) {
  glDeleteProgram(fragment_);
  const Picture plain = picture_of(draw);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
  glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, 0);
  picture_of(draw);
  pending_errors();  // a core context refuses the draw, with or without us
  glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, vertex_);
  EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
  EXPECT_EQ(pending_errors(), "");
}

// Draws vertices that transform feedback has captured: only the GPU knows their number.
TEST_P(ProgramStages, DrawsFromTransformFeedback) {
  const GLuint recorder = link_program(
      {.vertex = inputs +
                 "out vec4 place; out vec3 look;\nvoid main() { place = vec4(position.yx, 0.0, 1.0); look = color; "
                 "gl_Position = place; }\n",
       .varyings = {"place", "look"}});
  GLuint feedback[2] = {};
  glGenTransformFeedbacks(2, feedback);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback[1]);
  const GLuint buffer = make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, std::vector<GLfloat>(700));
  glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer, 0, 2800);
  glUseProgram(recorder);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_TRIANGLES);
  glDrawArrays(GL_TRIANGLES, 0, 6);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  use("out vec3 c;\n", "");
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 28, nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 28, byte_offset(16));
  expect_same_scene({2}, [&] { glDrawTransformFeedback(GL_TRIANGLES, feedback[1]); });
  expect_same_scene({4}, [&] { glDrawTransformFeedbackStream(GL_TRIANGLE_STRIP, feedback[1], 0); });
  expect_same_scene({8}, [&] { glDrawTransformFeedbackInstanced(GL_TRIANGLE_FAN, feedback[1], 2); });
}

// After a failed link, the previous executable stays in use.
TEST_P(ProgramStages, FailedRelinkOfTheProgramInUse) {
  const GLuint program = use("out vec3 c;\n", "");
  expect_same_scene({4}, draw);
  const Picture plain = picture_of(draw);
  attach_shader(program, GL_VERTEX_SHADER, "#version 430\nvoid nobody();\nvoid somebody() { nobody(); }\n");
  attach_shader(program, GL_VERTEX_SHADER, "#version 430\nout vec3 c;\nvoid main() { c = vec3(0.0); }\n");
  glLinkProgram(program);
  GLint linked = GL_TRUE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  ASSERT_EQ(linked, GL_FALSE);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(differing_pixels(plain, picture_of(draw)), 0);
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(ProgramStages, AProgramThatNeverLinkedIsNotUsed) {
  use("out vec3 c;\n", "");
  const GLuint broken = glCreateProgram();
  attach_shader(broken, GL_VERTEX_SHADER, "#version 430\nvoid nobody();\nvoid main() { nobody(); }\n");
  glLinkProgram(broken);
  glUseProgram(broken);
  EXPECT_NE(pending_errors(), "");
  expect_same_scene({4}, draw);
}

}  // namespace
}  // namespace glark::core::test
