// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// ARB_geometry_shader4: parameters of the program stand for the layouts of its geometry shader. Mesa has no such shaders,
// so a comment names the extension, and the test notes the calls.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <string>

#include "glark/core/context.h"
#include "glark/gl/hooks.h"
#include "tests/core/support/plain_context.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* plain = nullptr;
std::map<GLenum, GLint> parameters_set;

void get_program(GLuint program, GLenum name, GLint* value) {
  switch (name) {
    case GL_GEOMETRY_INPUT_TYPE_ARB: *value = GL_TRIANGLES; break;
    case GL_GEOMETRY_OUTPUT_TYPE_ARB: *value = GL_TRIANGLE_STRIP; break;
    case GL_GEOMETRY_VERTICES_OUT_ARB: *value = 3; break;
    default: plain->GetProgramiv(program, name, value);
  }
}
void set_parameter(GLuint program, GLenum name, GLint value) {
  if (name == GL_PROGRAM_SEPARABLE || name == GL_PROGRAM_BINARY_RETRIEVABLE_HINT) {
    plain->ProgramParameteri(program, name, value);
  } else {
    parameters_set[name] = value;
  }
}

// Draws a refined triangle through this geometry shader.
void draw_through(const std::string& first_line) {
  const PlainContext window;
  gl::Dispatch driver = window.gl;
  plain = &window.gl;
  driver.GetProgramiv = get_program;
  driver.ProgramParameteri = set_parameter;
  ContextOptions options;
  options.transparent = true;
  options.level = 1;
  options.refinement = Refinement::linear_outputs;
  options.left_draws = 0;
  const std::unique_ptr<Context> context = Context::create(driver, make_share_group(), options);
  const GLuint program = window.gl.CreateProgram();
  const auto attach = [&](GLenum stage, const std::string& source) {
    const char* const text = source.c_str();
    const GLuint shader = window.gl.CreateShader(stage);
    window.gl.ShaderSource(shader, 1, &text, nullptr);
    hook::CompileShader(*context, shader);
    window.gl.AttachShader(program, shader);
  };
  attach(GL_VERTEX_SHADER, "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex; }\n");
  attach(GL_GEOMETRY_SHADER,
         "#version 150 compatibility\n" + first_line +
             "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
             "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; EmitVertex(); } }\n");
  hook::LinkProgram(*context, program);
  hook::UseProgram(*context, program);
  const std::array<GLfloat, 6> corners{-1, -1, 1, -1, 0, 1};
  window.gl.EnableClientState(GL_VERTEX_ARRAY);
  window.gl.VertexPointer(2, GL_FLOAT, 0, corners.data());
  parameters_set.clear();
  hook::DrawArrays(*context, GL_TRIANGLES, 0, 3);
  context->release();
}

TEST(GeometryParameters, AreThoseOfTheProgram) {
  draw_through("// #extension GL_ARB_geometry_shader4 : enable\n");
  EXPECT_EQ(parameters_set, (std::map<GLenum, GLint>{{GL_GEOMETRY_VERTICES_OUT_ARB, 3},
                                                     {GL_GEOMETRY_INPUT_TYPE_ARB, GL_TRIANGLES},
                                                     {GL_GEOMETRY_OUTPUT_TYPE_ARB, GL_TRIANGLE_STRIP}}));
}

TEST(GeometryParameters, OfShadersWithLayoutsAreNotSet) {
  draw_through("");
  EXPECT_TRUE(parameters_set.empty());
}

}  // namespace
}  // namespace glark::core::test
