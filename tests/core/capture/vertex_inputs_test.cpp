// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Inputs and outputs of vertex stages beyond plain floats: doubles, draw parameters, outputs that are linear on the
// screen.
#include "tests/core/support/program_scene.h"
#include "tests/core/support/scene.h"

namespace glark::core::test {
namespace {

class VertexInputs : public ProgramScene {};

INSTANTIATE_TEST_SUITE_P(All, VertexInputs, testing::Values(Profile::compatibility, Profile::core), profile_name);

const std::string perspective = "gl_Position = vec4(position * 1.2, color.x * 0.5, 1.0 + 2.0 * color.y);\n";

TEST_P(VertexInputs, NoPerspectiveUnderPerspective) {
  use("noperspective out vec3 c; out vec3 d;\n", perspective + "d = color;\n",
      "#version 430\nnoperspective in vec3 c; in vec3 d; out vec4 result;\n"
      "void main() { result = vec4(c.x, d.y, c.z, 1.0); }\n");
  expect_same_scene({4}, draw);
}

TEST_P(VertexInputs, NoPerspectiveBlockOfAnotherShaderObject) {
  const GLuint program = glCreateProgram();
  attach_shader(program, GL_VERTEX_SHADER,
                "#version 430\nout Look { noperspective vec3 c; noperspective vec2 d[2]; };\nvoid look(vec3 color) { c "
                "= color; d[0] "
                "= color.xy; d[1] = color.yz; }\n");
  attach_shader(program, GL_VERTEX_SHADER,
                inputs + "void look(vec3 color);\nvoid main() {" + perspective + "look(color); }\n");
  attach_shader(program, GL_FRAGMENT_SHADER,
                "#version 430\nin Look { noperspective vec3 c; noperspective vec2 d[2]; }; out vec4 result;\n"
                "void main() { result = vec4(c.x, d[0].y, d[1].y, 1.0); }\n");
  glLinkProgram(program);
  glUseProgram(program);
  expect_same_scene({4}, draw);
}

TEST_P(VertexInputs, DoubleVectors) {
  use("layout(location = 4) in dvec3 a; layout(location = 6) in dvec4 b; layout(location = 8) in double s; out vec3 "
      "c;\n",
      "c = vec3(a * s + b.xyz * b.w);\n");
  std::vector<GLdouble> data;
  for (int i = 0; i < 6; ++i) data.insert(data.end(), {0.1 * i, 0.5, 1.0 - 0.1 * i, 0.3, 0.1 * i, 0.0, 0.5, 0.7});
  make_buffer(GL_ARRAY_BUFFER, data);
  glVertexAttribLPointer(4, 3, GL_DOUBLE, 64, nullptr);
  glVertexAttribLPointer(6, 4, GL_DOUBLE, 64, byte_offset(24));
  glVertexAttribLPointer(8, 1, GL_DOUBLE, 64, byte_offset(56));
  for (const GLuint location : {4, 6, 8}) glEnableVertexAttribArray(location);
  expect_same_scene({4}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
}

// A difference far beyond the digits of a float survives.
TEST_P(VertexInputs, DoublesAreCapturedExactly) {
  use("layout(location = 4) in dvec2 a; out vec3 c;\n", "c = vec3((a - dvec2(1.0LF, 2.0LF)) * 1.0e12LF, 0.5);\n");
  std::vector<GLdouble> data;
  for (int i = 0; i < 6; ++i) data.insert(data.end(), {1.0 + 0.2e-12 * i, 2.0 + (1.0 - 0.2 * i) * 1e-12});
  make_buffer(GL_ARRAY_BUFFER, data);
  glVertexAttribLPointer(4, 2, GL_DOUBLE, 0, nullptr);
  glEnableVertexAttribArray(4);
  expect_same_scene({4}, draw);
}

TEST_P(VertexInputs, DoubleMatrix) {
  use("layout(location = 4) in dmat2x3 m; out vec3 c;\n", "c = vec3(m[0].zx, m[1].y);\n");
  std::vector<GLdouble> data;
  for (int i = 0; i < 6; ++i) data.insert(data.end(), {0.1 * i, 9.0, 0.7, 9.0, 1.0 - 0.1 * i, 9.0});
  make_buffer(GL_ARRAY_BUFFER, data);
  for (GLuint column = 0; column < 2; ++column) {
    glVertexAttribLPointer(4 + column, 3, GL_DOUBLE, 48, byte_offset(24 * column));
    glEnableVertexAttribArray(4 + column);
  }
  expect_same_scene({4}, draw);
}

// There are more attributes than an instance can have: the records are read from a storage block.
TEST_P(VertexInputs, MoreAttributesThanAnInstanceHas) {
  use("layout(location = 4) in mat4 m; layout(location = 8) in ivec3 n; out vec3 c;\n",
      "gl_Position = m * gl_Position; c = vec3(c.xy * m[3].w, float(n.z) / 7.0);\n");
  std::vector<GLfloat> matrices;
  for (int i = 0; i < 6; ++i)
    matrices.insert(matrices.end(), {0.8F, 0, 0, 0, 0, 0.7F, 0, 0, 0, 0, 1, 0, 0.1F, 0, 0, 1});
  make_buffer(GL_ARRAY_BUFFER, matrices);
  for (GLuint column = 0; column < 4; ++column) {
    glVertexAttribPointer(4 + column, 4, GL_FLOAT, GL_FALSE, 64, byte_offset(16 * column));
    glEnableVertexAttribArray(4 + column);
  }
  glVertexAttribI3i(8, -1, 2, 5);
  expect_same_scene({4}, draw);
  expect_same_scene({4, GL_LINEAR_INPUTS_ARK}, draw);
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2, 3, 4, 5});
  expect_same_scene({8}, [] {
    glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_BYTE, nullptr);
    glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_BYTE, nullptr);
  });
}

// Uses the bins of tags that vary, and triangles whose number only the GPU knows.
TEST_P(VertexInputs, ManyAttributesWithTagsAndWithRestart) {
  use("layout(location = 4) in mat4 m; out vec3 c;\n", "c = c * m[3].w;\n");
  for (GLuint column = 0; column < 4; ++column) glVertexAttrib4f(4 + column, 0, 0, 0, 0.7F);
  make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>{0, 3, 1, 2, 3, 1});
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw);
  refine_uniformly(3, GL_LINEAR_OUTPUTS_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
  glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
  EXPECT_GT(generated_primitives, 16U);
  glDisable(GL_DEPTH_TAG_ARRAY_ARK);
  glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  glARKParameteriARK(GL_EDGE_PIXELS_ARK, 8);
  EXPECT_LE(differing_pixels(plain, picture_of(draw)), tolerated_pixels);
  EXPECT_GT(generated_primitives, 16U);
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2, 255, 3, 4, 5});
  glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  expect_same_scene({2}, [] { glDrawElements(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, nullptr); });
}

TEST_P(VertexInputs, ManyAttributesOfAnOldShader) {
  std::string vertex =
      "#version 120\nattribute vec2 position; attribute vec3 color; attribute mat4 m; varying vec3 c;\n"
      "void main() { gl_Position = vec4(position, 0.0, 1.0); c = color * m[3].w; }\n";
  if (GetParam() == Profile::core) vertex.replace(vertex.find("120"), 3, "140");
  const GLuint program = glCreateProgram();
  attach_shader(program, GL_VERTEX_SHADER, vertex);
  attach_shader(program, GL_FRAGMENT_SHADER,
                GetParam() == Profile::core
                    ? "#version 140\nin vec3 c; out vec4 result; void main() { result = vec4(c, 1.0); }\n"
                    : "#version 120\nvarying vec3 c; void main() { gl_FragColor = vec4(c, 1.0); }\n");
  glBindAttribLocation(program, 0, "position");
  glBindAttribLocation(program, 1, "color");
  glBindAttribLocation(program, 4, "m");
  glLinkProgram(program);
  glUseProgram(program);
  for (GLuint column = 0; column < 4; ++column) glVertexAttrib4f(4 + column, 0, 0, 0, 0.7F);
  expect_same_scene({4}, draw);
}

const std::string draw_parameters = "#extension GL_ARB_shader_draw_parameters : require\n";

TEST_P(VertexInputs, DrawId) {
  std::string vertex = inputs;
  vertex.insert(vertex.find('\n') + 1, draw_parameters);
  glUseProgram(link_program(
      {.vertex = vertex + "out vec3 c;\nvoid main() { gl_Position = vec4(position * 0.5 + (gl_DrawIDARB - 0.5) * 0.8, "
                          "0.0, 1.0); c = vec3(gl_DrawIDARB, color.yz); }\n",
       .fragment = pass_color}));
  const GLint first[] = {0, 0};
  const GLsizei count[] = {6, 6};
  const auto draws = [&] { glMultiDrawArrays(GL_TRIANGLE_STRIP, first, count, 2); };
  expect_same_scene({8}, draws);
  expect_same_scene({8, GL_LINEAR_INPUTS_ARK}, draws);
}

TEST_P(VertexInputs, BaseVertexAndBaseInstance) {
  std::string vertex = inputs;
  vertex.insert(vertex.find('\n') + 1, draw_parameters);
  glUseProgram(
      link_program({.vertex = vertex + "out vec3 c;\nvoid main() { gl_Position = vec4(position, 0.0, 1.0); c = "
                                       "vec3(gl_BaseVertexARB / 4.0, gl_BaseInstanceARB / 9.0, color.z); }\n",
                    .fragment = pass_color}));
  make_buffer(GL_ELEMENT_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2, 1, 2, 3});
  const auto draws = [] {
    glDrawElementsInstancedBaseVertexBaseInstance(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, nullptr, 1, 2, 7);
    glDrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr, 0);
  };
  expect_same_scene({3}, draws);
  expect_same_scene({3, GL_LINEAR_INPUTS_ARK}, draws);
}

}  // namespace
}  // namespace glark::core::test
