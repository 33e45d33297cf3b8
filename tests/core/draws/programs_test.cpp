// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs of the application: every kind of input, uniform and life cycle. The picture must not change.
#include "tests/core/support/program_scene.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

class DrawsPrograms : public ProgramScene {};

INSTANTIATE_TEST_SUITE_P(All, DrawsPrograms, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(DrawsPrograms, FlatOutputsUnderBothConventions) {
  const GLuint program = link_program(
      {.vertex = inputs + "flat out vec3 c; flat out ivec2 n;\nvoid main() { gl_Position = vec4(position, 0.0, 1.0); "
                          "c = color; n = ivec2(color.xy * 200.0); }\n",
       .fragment = "#version 430\nflat in vec3 c; flat in ivec2 n; out vec4 result;\n"
                   "void main() { result = vec4(c.x, vec2(n) / 255.0, 1.0); }\n"});
  glUseProgram(program);
  for (const GLenum convention : {GL_LAST_VERTEX_CONVENTION, GL_FIRST_VERTEX_CONVENTION}) {
    glProvokingVertex(convention);
    expect_same_scene({4, GL_LINEAR_OUTPUTS_ARK}, draw);
    expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
  }
}

TEST_P(DrawsPrograms, VertexId) {
  use("out vec3 c;\n", "c = vec3(float(gl_VertexID & 1), float(gl_VertexID >> 1 & 1), float(gl_VertexID) / 6.0);\n");
  expect_same_scene({4, GL_LINEAR_OUTPUTS_ARK}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
}

TEST_P(DrawsPrograms, VerticesFromVertexIdAlone) {
  const GLuint program = link_program(
      {.vertex = "#version 430\nout vec3 c;\nvoid main() { vec2 p = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                 "gl_Position = vec4(p * 1.5 - 0.75, 0.0, 1.0); c = vec3(p, 0.5); }\n",
       .fragment = pass_color});
  glUseProgram(program);
  glDisableVertexAttribArray(0);
  glDisableVertexAttribArray(1);
  expect_same_scene({2}, [] { glDrawArrays(GL_TRIANGLE_STRIP, 0, 4); });
}

TEST_P(DrawsPrograms, DoubleMatrixUniformSetBeforeTheFirstDraw) {
  const GLuint program = use("uniform dmat2x3 tint; out vec3 c;\n", "c = vec3(tint[1]);\n");
  const GLdouble columns[] = {0, 0, 0, 0.25, 1, 0.5};
  glUniformMatrix2x3dv(glGetUniformLocation(program, "tint"), 1, GL_FALSE, columns);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, LongIntegersSetBeforeTheFirstDraw) {
  const GLuint program = link_program(
      {.vertex = inputs + "out vec3 c;\nvoid main() { gl_Position = vec4(position, 0.0, 1.0); c = color; }\n",
       .fragment = "#version 430\n#extension GL_ARB_gpu_shader_int64 : require\n"
                   "uniform int64_t below; uniform u64vec2 above[2]; in vec3 c; out vec4 result;\n"
                   "void main() { bool right = below == -5000000000L && above[1] == u64vec2(7000000000UL, 3UL);\n"
                   "  result = vec4(right ? c : vec3(0.0), 1.0); }\n"});
  const GLuint64 pairs[] = {1, 2, 7000000000, 3};
  glUseProgram(program);
  glUniform1i64ARB(glGetUniformLocation(program, "below"), -5000000000);
  glUniform2ui64vARB(glGetUniformLocation(program, "above"), 2, pairs);
  expect_same_scene({4, GL_LINEAR_OUTPUTS_ARK}, draw);
}

// The first refined draw builds its programs while the application's transform feedback is open.
TEST_P(DrawsPrograms, FirstDrawWhileTransformFeedbackIsPaused) {
  const GLuint recorder = glCreateProgram();
  const char* source = "#version 430\nout float x;\nvoid main() { x = 1.0; gl_Position = vec4(0.0); }\n";
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  glAttachShader(recorder, shader);
  const char* varying = "x";
  glTransformFeedbackVaryings(recorder, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(recorder);
  const GLuint program = use("out vec3 c;\n", "");
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 64, nullptr, GL_STATIC_READ);
  const Picture plain = picture_of(draw);
  glUseProgram(recorder);
  glBeginTransformFeedback(GL_POINTS);
  glPauseTransformFeedback();
  glUseProgram(program);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
  const Picture refined = picture_of(draw);
  glDisable(GL_ARK);
  glUseProgram(recorder);
  glResumeTransformFeedback();
  glEndTransformFeedback();
  EXPECT_EQ(pending_errors(), "");
  EXPECT_LE(differing_pixels(plain, refined), tolerated_pixels);
  EXPECT_EQ(generated_primitives, 4U << 4);
}

TEST_P(DrawsPrograms, MatrixAttribute) {
  glUseProgram(link_program(
      {.vertex = "#version 430\nlayout(location = 0) in vec2 position; layout(location = 4) in mat4 m; out vec3 c;\n"
                 "void main() { gl_Position = m * vec4(position, 0.0, 1.0); c = vec3(position, m[3].w); }\n",
       .fragment = pass_color}));
  std::vector<GLfloat> matrices;
  for (int i = 0; i < 6; ++i)
    matrices.insert(matrices.end(), {0.8F, 0, 0, 0, 0, 0.7F, 0, 0, 0, 0, 1, 0, 0.1F, 0, 0, 1});
  make_buffer(GL_ARRAY_BUFFER, matrices);
  for (GLuint column = 0; column < 4; ++column) {
    glVertexAttribPointer(4 + column, 4, GL_FLOAT, GL_FALSE, 64, byte_offset(16 * column));
    glEnableVertexAttribArray(4 + column);
  }
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, IntegerAttributes) {
  use("layout(location = 4) in ivec2 a; layout(location = 5) in uint b; flat out vec3 c;\n",
      "c = vec3(vec2(a), float(b)) / 8.0;\n",
      "#version 430\nflat in vec3 c; out vec4 result;\nvoid main() { result = vec4(c, 1.0); }\n");
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLbyte>{8, 1, 7, 2, 6, 3, 5, 4, 4, 5, 3, 6});
  glVertexAttribIPointer(4, 2, GL_BYTE, 2, nullptr);
  glEnableVertexAttribArray(4);
  glVertexAttribI1ui(5, 6);
  expect_same_scene({4}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
}

TEST_P(DrawsPrograms, ArrayOfAttributes) {
  use("layout(location = 4) in vec2 shift[3]; out vec3 c;\n", "c = vec3(shift[0].x, shift[1].y, shift[2].x);\n");
  for (GLuint i = 0; i < 3; ++i) glVertexAttrib2f(4 + i, 0.5F + 0.2F * static_cast<GLfloat>(i), 0.9F);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, ConstantAttribute) {
  glDisableVertexAttribArray(1);
  use("out vec3 c;\n", "");
  expect_same_scene({8}, [] {
    glVertexAttrib3f(1, 1, 0.5F, 0);
    draw();
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, picture_size / 2, picture_size);
    glVertexAttrib3f(1, 0, 0.5F, 1);
    draw();
    glDisable(GL_SCISSOR_TEST);
  });
}

TEST_P(DrawsPrograms, UniformsChangedBetweenDraws) {
  const GLuint program = use(
      "uniform vec2 shift; uniform float scale[3]; uniform mat2 turn; uniform ivec2 n; uniform bool on; out vec3 c;\n",
      "gl_Position = vec4(turn * position * scale[2] + shift, 0.0, 1.0); c = on ? vec3(n, 1.0) / 9.0 : c;\n");
  const GLint scale = glGetUniformLocation(program, "scale");
  const GLint shift = glGetUniformLocation(program, "shift");
  const GLint turn = glGetUniformLocation(program, "turn");
  const GLint n = glGetUniformLocation(program, "n");
  const GLint on = glGetUniformLocation(program, "on");
  const GLfloat scales[3] = {9, 9, 0.4F};
  const GLfloat matrices[2][4] = {{1, 0, 0, 1}, {0, 1, -1, 0}};
  glUniform1fv(scale, 3, scales);
  expect_same_scene({8}, [&] {
    for (int i = 0; i < 2; ++i) {
      glUniform2f(shift, i == 0 ? -0.5F : 0.5F, 0.1F);
      glUniformMatrix2fv(turn, 1, GL_FALSE, matrices[i]);
      glUniform2i(n, 3, 9 * i);
      glProgramUniform1i(program, on, i);
      draw();
    }
  });
  glUniform1f(scale + 2, 0.7F);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, UniformInitializersAndStructures) {
  const GLuint program =
      use("struct Light { vec3 color; float power[2]; }; uniform Light lights[2]; uniform vec3 base = vec3(0.1, 0.2, "
          "0.3); out vec3 c;\n",
          "c = base + lights[1].color * lights[0].power[1];\n");
  glUniform3f(glGetUniformLocation(program, "lights[1].color"), 1, 0.5F, 0.25F);
  glUniform1f(glGetUniformLocation(program, "lights[0].power[1]"), 0.7F);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, UniformBlocks) {
  const GLuint program =
      use("layout(std140) uniform Look { vec4 tint; } look[2]; layout(std430, binding = 3) readonly buffer Data { "
          "float data[]; }; out vec3 c;\n",
          "c = c * look[1].tint.rgb * data[2] + look[0].tint.rgb;\n");
  const GLuint blocks[2] = {make_buffer(GL_UNIFORM_BUFFER, std::vector<GLfloat>{0, 0, 0.2F, 0}),
                            make_buffer(GL_UNIFORM_BUFFER, std::vector<GLfloat>{1, 0.5F, 0.2F, 0})};
  glBindBufferBase(GL_UNIFORM_BUFFER, 5, blocks[0]);
  glBindBufferBase(GL_UNIFORM_BUFFER, 7, blocks[1]);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Look[0]"), 5);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Look[1]"), 7);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3,
                   make_buffer(GL_SHADER_STORAGE_BUFFER, std::vector<GLfloat>{0, 0, 0.8F, 0}));
  expect_same_scene({4}, draw);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Look[0]"), 7);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "Look[1]"), 5);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, BlocksWithLongNames) {
  const std::string look(300, 'l'), data(600, 'd');
  const GLuint program =
      use("layout(std140) uniform " + look + " { vec4 tint; }; layout(std430, binding = 3) readonly buffer " + data +
              " { float data[]; }; out vec3 c;\n",
          "c = c * tint.rgb * data[2];\n");
  const auto make_block = [](GLenum target, GLuint binding, const std::vector<GLfloat>& values) {
    glBindBufferBase(target, binding, make_buffer(target, values));
  };
  make_block(GL_UNIFORM_BUFFER, 5, {0, 0, 0.2F, 0});
  make_block(GL_UNIFORM_BUFFER, 7, {1, 0.5F, 0.2F, 0});
  make_block(GL_SHADER_STORAGE_BUFFER, 3, {0, 0, 0.8F, 0});
  make_block(GL_SHADER_STORAGE_BUFFER, 4, {0, 0, 0.4F, 0});
  const auto bind = [&](GLuint uniforms, GLuint storage) {
    glUniformBlockBinding(program, glGetUniformBlockIndex(program, look.c_str()), uniforms);
    glShaderStorageBlockBinding(program, glGetProgramResourceIndex(program, GL_SHADER_STORAGE_BLOCK, data.c_str()),
                                storage);
  };
  bind(5, 3);
  expect_same_scene({4}, draw);
  bind(7, 4);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, Samplers) {
  const GLuint program = use("uniform sampler2D height; uniform sampler2D other[2]; out vec3 c;\n",
                             "c = texture(height, vec2(0.5)).rgb * 0.5 + textureLod(other[1], vec2(0.5), 0.0).rgb;\n",
                             "#version 430\nuniform sampler2D height; in vec3 c; out vec4 result;\n"
                             "void main() { result = vec4(c + texture(height, vec2(0.5)).rgb * 0.25, 1.0); }\n");
  const GLubyte texels[3][4] = {{255, 0, 0, 255}, {0, 128, 0, 255}, {0, 0, 200, 255}};
  for (GLuint unit = 0; unit < 3; ++unit) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels[unit]);
  }
  glUniform1i(glGetUniformLocation(program, "height"), 2);
  glUniform1i(glGetUniformLocation(program, "other[1]"), 1);
  expect_same_scene({4}, draw);
  glUniform1i(glGetUniformLocation(program, "height"), 0);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, UniformSetAfterTheFirstRefinedDraw) {
  const GLuint program = use("uniform vec3 tint; out vec3 c;\n", "c = c * tint;\n");
  const GLint tint = glGetUniformLocation(program, "tint");
  glUniform3f(tint, 1, 1, 1);
  refine_uniformly(2);
  picture_of(draw);
  glUseProgram(0);
  glProgramUniform3f(program, tint, 1, 0.2F, 0.5F);
  glUseProgram(program);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, Relink) {
  const GLuint program = use("uniform vec3 tint; out vec3 c;\n", "c = c * tint;\n");
  glUniform3f(glGetUniformLocation(program, "tint"), 1, 0, 0);
  expect_same_scene({4}, draw);
  GLuint shaders[2] = {};
  glGetAttachedShaders(program, 2, nullptr, shaders);
  GLint type = 0;
  glGetShaderiv(shaders[0], GL_SHADER_TYPE, &type);
  const GLuint vertex = shaders[type == GL_VERTEX_SHADER ? 0 : 1];
  const std::string source =
      inputs +
      "uniform vec3 tint; out vec3 c;\nvoid main() { gl_Position = vec4(0.5 * position, 0.0, 1.0); c = tint; }\n";
  const char* const text = source.c_str();
  glShaderSource(vertex, 1, &text, nullptr);
  glCompileShader(vertex);
  glLinkProgram(program);
  glUniform3f(glGetUniformLocation(program, "tint"), 0, 1, 0.5F);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, DeletedWhileInUse) {
  const GLuint program = use("out vec3 c;\n", "");
  refine_uniformly(2);
  picture_of(draw);
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw);
  glDeleteProgram(program);
  glEnable(GL_ARK);
  for (int i = 0; i < 2; ++i) EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
  GLint current = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  EXPECT_EQ(current, static_cast<GLint>(program));
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(DrawsPrograms, DeletedAndAnotherOneInstead) {
  const GLuint first = use("out vec3 c;\n", "c = c.bgr;\n");
  expect_same_scene({4}, draw);
  glUseProgram(0);
  glDeleteProgram(first);
  use("out vec3 c;\n", "c = 1.0 - c;\n");
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, SeveralProgramsInTurn) {
  const GLuint a = use("uniform float x; out vec3 c;\n", "gl_Position = vec4(position * 0.5 + x, 0.0, 1.0);\n");
  const GLuint b =
      use("uniform float x; out vec3 c;\n", "gl_Position = vec4(position * 0.5 - x, 0.0, 1.0); c = 1.0 - c;\n");
  expect_same_scene({8}, [a, b] {
    for (const GLuint program : {a, b}) {
      glUseProgram(program);
      glUniform1f(glGetUniformLocation(program, "x"), program == a ? 0.5F : 0.4F);
      draw();
    }
  });
}

TEST_P(DrawsPrograms, ClipDistancesAndPointSize) {
  use("out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[2]; float gl_PointSize; }; out vec3 c;\n",
      "gl_ClipDistance[0] = position.x + 0.3; gl_ClipDistance[1] = 0.6 - position.y; gl_PointSize = 2.0;\n");
  glEnable(GL_CLIP_DISTANCE0);
  glEnable(GL_CLIP_DISTANCE1);
  expect_same_scene({4}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
}

TEST_P(DrawsPrograms, InterfaceBlockAndQualifiers) {
  const std::string block = "Interface { noperspective vec3 a; centroid vec2 b; flat int n; }";
  use("out " + block + " face; out vec3 c;\n", "face.a = c; face.b = c.xy; face.n = 3;\n",
      "#version 430\nin " + block +
          " face; in vec3 c; out vec4 result;\nvoid main() { result = vec4(face.a.x, face.b.y, c.z * float(face.n) / "
          "3.0, 1.0); }\n");
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, PerspectiveWithDepth) {
  use("out vec3 c;\n", "gl_Position = vec4(position * 1.2, color.x * 0.5, 1.0 + 0.7 * color.y);\n");
  glEnable(GL_DEPTH_TEST);
  expect_same_scene({4}, draw);
}

TEST_P(DrawsPrograms, GeometryShader) {
  const GLuint program = glCreateProgram();
  attach_shader(program, GL_VERTEX_SHADER,
                inputs + "out vec3 d;\nvoid main() { gl_Position = vec4(position, 0.0, 1.0); d = color; }\n");
  attach_shader(
      program, GL_GEOMETRY_SHADER,
      "#version 430\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out; in vec3 d[]; out vec3 c;\n"
      "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position * vec4(0.8, 0.8, 1.0, 1.0); c = "
      "d[i]; EmitVertex(); } }\n");
  attach_shader(program, GL_FRAGMENT_SHADER, pass_color);
  glLinkProgram(program);
  glUseProgram(program);
  expect_same_scene({4}, draw);
}

// Two contexts share programs and buffers; each has its own vertex arrays and its own refinement.
TEST_P(DrawsPrograms, SharedContexts) {
  const GLuint program = use("uniform vec3 tint; out vec3 c;\n", "c = c * tint;\n");
  const GLint tint = glGetUniformLocation(program, "tint");
  glUniform3f(tint, 1, 1, 0);
  expect_same_scene({4}, draw);
  OsmesaContext other(GetParam(), &context_);
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  point_generic_arrays(nullptr);
  glUseProgram(program);
  glUniform3f(tint, 0, 1, 1);
  expect_same_scene({4}, draw);
  context_.make_current();
  glUniform3f(tint, 1, 0, 1);
  expect_same_scene({4}, draw);
}

}  // namespace
}  // namespace glark::core::test
