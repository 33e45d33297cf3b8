// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs at the limits: very large ones, malformed ones, and ones without source.
#include "tests/core/support/program_scene.h"
#include "tests/core/support/scene.h"
#include "tests/core/support/spirv_shaders.h"

namespace glark::core::test {
namespace {

class ExtremePrograms : public ProgramScene {
 protected:
  // The picture is the same as without glark, with only the coarse triangles.
  static void expect_left_alone() {
    glDisable(GL_ARK);
    const Picture plain = picture_of(draw);
    EXPECT_GT(differing_pixels(plain, Picture(plain.size(), 0)), visible_pixels);
    refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(differing_pixels(plain, picture_of(draw)), 0);
    EXPECT_EQ(generated_primitives, 4U);
    EXPECT_EQ(pending_errors(), "");
  }
};

INSTANTIATE_TEST_SUITE_P(All, ExtremePrograms, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(ExtremePrograms, SixteenThousandUniformComponents) {
  const GLuint program = use("uniform vec4 many[3900]; uniform int at; out vec3 c;\n", "c = c * many[at].x;\n");
  glUniform1i(glGetUniformLocation(program, "at"), 3777);
  const GLint element = glGetUniformLocation(program, "many[3777]");
  glUniform4f(element, 0.7F, 0, 0, 0);
  expect_same_scene({4}, draw);
  glUniform4f(element, 1.3F, 0, 0, 0);
  expect_same_scene({4}, draw);
}

TEST_P(ExtremePrograms, UniformArraysOfStructures) {
  const GLuint program =
      use("struct Knob { vec2 a[2]; mat2x3 m; }; struct Board { Knob knobs[3]; int chosen; }; uniform Board "
          "boards[40]; out "
          "vec3 c;\n",
          "c = boards[39].knobs[boards[39].chosen].m * boards[3].knobs[2].a[1];\n");
  const GLfloat matrix[] = {0.9F, 0, 0.3F, 0, 0.8F, 0.4F};
  glUniform1i(glGetUniformLocation(program, "boards[39].chosen"), 1);
  glUniform2f(glGetUniformLocation(program, "boards[3].knobs[2].a[1]"), 0.6F, 0.9F);
  glUniformMatrix2x3fv(glGetUniformLocation(program, "boards[39].knobs[1].m"), 1, GL_FALSE, matrix);
  expect_same_scene({4}, draw);
}

TEST_P(ExtremePrograms, AMegabyteOfShader) {
  std::string functions;
  for (int i = 0; functions.size() < (1U << 20); ++i) {
    const std::string number = std::to_string(i);
    functions +=
        "float scaled" + number + "(float x) { float y = x * " + number + ".0; /* of no use */ return y - x; }\n";
    functions += "// " + std::string(400, 'x') + "\n";
  }
  use(functions + "out vec3 c;\n", "c.x += scaled1(c.y);\n");
  expect_same_scene({4}, draw);
}

TEST_P(ExtremePrograms, MalformedShadersAreReportedByTheCompilerAlone) {
  const GLuint good = use("out vec3 c;\n", "");
  for (const char* const source : {"", "#version 430\nvoid main( {", "#version 430\n#if 1\nvoid main() {}\n",
                                   "\"'\\\x01\xff", "#version 430\nin vec3 position[;\n/* never closed"}) {
    const GLuint program = glCreateProgram();
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_TRUE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    EXPECT_EQ(compiled, GL_FALSE) << source;
    glAttachShader(program, shader);
    glLinkProgram(program);
    EXPECT_EQ(pending_errors(), "") << source;
    refine_uniformly(2);
    glUseProgram(program);
    EXPECT_NE(pending_errors(), "") << source;
    draw();
    EXPECT_EQ(pending_errors(), "") << source;  // by the program before
    glDisable(GL_ARK);
    glDeleteProgram(program);
  }
  GLint current = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  EXPECT_EQ(static_cast<GLuint>(current), good);
}

TEST_P(ExtremePrograms, BindingsAfterTheLinkWaitForTheNextOne) {
  const GLuint program = glCreateProgram();
  attach_shader(
      program, GL_VERTEX_SHADER,
      "#version 430\nin vec2 position; in vec3 color; out vec3 c;\nvoid main() { gl_Position = vec4(position, 0.0, "
      "1.0); c = color; }\n");
  attach_shader(program, GL_FRAGMENT_SHADER, pass_color);
  glBindAttribLocation(program, 0, "position");
  glBindAttribLocation(program, 1, "color");
  glLinkProgram(program);
  glUseProgram(program);
  glBindAttribLocation(program, 1, "position");
  glBindAttribLocation(program, 0, "color");
  glBindFragDataLocation(program, 3, "result");
  expect_same_scene({4}, draw);
  glBindFragDataLocation(program, 0, "result");
  glLinkProgram(program);
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), nullptr);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), byte_offset(8));
  expect_same_scene({4}, draw);
}

// The sources of a binary are known if it was taken from a program that was linked here.
TEST_P(ExtremePrograms, ProgramFromABinary) {
  const GLuint program = glCreateProgram();
  glProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  attach_shader(program, GL_VERTEX_SHADER,
                inputs + "out vec3 c;\nvoid main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n");
  attach_shader(program, GL_FRAGMENT_SHADER, pass_color);
  glLinkProgram(program);
  GLint length = 0;
  glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
  if (length == 0) GTEST_SKIP() << "this GL gives no binaries";
  std::vector<GLubyte> binary(static_cast<std::size_t>(length));
  GLenum format = 0;
  glGetProgramBinary(program, length, nullptr, &format, binary.data());
  const GLuint loaded = glCreateProgram();
  glProgramBinary(loaded, format, binary.data(), length);
  glUseProgram(loaded);
  expect_same_scene({4}, draw);
}

// This test needs new shader objects: if they had GLSL before, Mesa 22.3 frees memory twice.
TEST_P(ExtremePrograms, Spirv) {
  const auto specialize = proc<PFNGLSPECIALIZESHADERPROC>("glSpecializeShader");
  const GLuint program = glCreateProgram();
  for (const GLenum stage : {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}) {
    const std::vector<GLuint>& words = stage == GL_VERTEX_SHADER ? spirv_vertex : spirv_fragment;
    const GLuint shader = glCreateShader(stage);
    glShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V, words.data(), static_cast<GLsizei>(words.size() * 4));
    if (specialize == nullptr || glGetError() != GL_NO_ERROR) GTEST_SKIP() << "this GL takes no SPIR-V";
    specialize(shader, "main", 0, nullptr, nullptr);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  ASSERT_EQ(linked, GL_TRUE);
  glUseProgram(program);
  expect_left_alone();
}

}  // namespace
}  // namespace glark::core::test
