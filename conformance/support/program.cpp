// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/program.h"

#include <utility>

namespace glark::conformance {
namespace {

bool compile(GLuint program, GLenum stage, const std::string& source, std::string& log) {
  const GLuint shader = gl.CreateShader(stage);
  const char* const text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == 0) {
    char lines[2000] = "";
    gl.GetShaderInfoLog(shader, sizeof(lines), nullptr, lines);
    log += lines;
  }
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);
  return compiled != 0;
}

}  // namespace

const char plain_vertex_shader[] =
    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour; out vec4 colour;\n"
    "void main() { colour = vertex_colour; gl_Position = position; }\n";

std::string glsl_head(const Test& t) {
  if (t.is_gles()) return "#version 320 es\nprecision highp float; precision highp int;\n";
  return t.is_compat() ? "#version 430 compatibility\n" : "#version 430 core\n";
}

GLuint try_program(const Sources& sources, std::string& log) {
  const GLuint program = gl.CreateProgram();
  bool built = compile(program, GL_VERTEX_SHADER, sources.vertex, log);
  built = compile(program, GL_FRAGMENT_SHADER, sources.fragment, log) && built;
  if (!sources.geometry.empty()) built = compile(program, GL_GEOMETRY_SHADER, sources.geometry, log) && built;
  if (!sources.captured.empty())
    gl.TransformFeedbackVaryings(program, static_cast<GLsizei>(sources.captured.size()), sources.captured.data(),
                                 GL_INTERLEAVED_ATTRIBS);
  GLint linked = 0;
  if (built) {
    gl.LinkProgram(program);
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    char lines[2000] = "";
    gl.GetProgramInfoLog(program, sizeof(lines), nullptr, lines);
    log += lines;
  }
  if (linked != 0) return program;
  gl.DeleteProgram(program);
  return 0;
}

GLuint build_program(Test& t, const Sources& sources) {
  Sources whole = sources;
  whole.vertex = glsl_head(t) + sources.vertex;
  whole.fragment = glsl_head(t) + sources.fragment;
  if (!sources.geometry.empty()) whole.geometry = glsl_head(t) + sources.geometry;
  std::string log;
  const GLuint program = try_program(whole, log);
  if (program == 0) t.internal_error("a program of the suite does not build: " + log);
  return program;
}

GLuint separable_program(const Test& t, GLenum stage, const std::string& source) {
  const bool has_block = stage == GL_VERTEX_SHADER && !t.is_gles();
  const std::string whole = glsl_head(t) + (has_block ? "out gl_PerVertex { vec4 gl_Position; };\n" : "") + source;
  const char* const text = whole.c_str();
  return gl.CreateShaderProgramv(stage, 1, &text);
}

Pipeline bind_pipeline(Test& t, const std::string& vertex, const std::string& fragment) {
  Pipeline pipeline;
  pipeline.vertex_program = separable_program(t, GL_VERTEX_SHADER, vertex);
  pipeline.fragment_program = separable_program(t, GL_FRAGMENT_SHADER, fragment);
  gl.GenProgramPipelines(1, &pipeline.name);
  gl.UseProgramStages(pipeline.name, GL_VERTEX_SHADER_BIT, pipeline.vertex_program);
  gl.UseProgramStages(pipeline.name, GL_FRAGMENT_SHADER_BIT, pipeline.fragment_program);
  gl.BindProgramPipeline(pipeline.name);
  return pipeline;
}

void require_refinable(Test& t, GLuint program) {
  GLint built = GL_FALSE;
  gl.GetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  char log[2000] = "";
  if (built == GL_FALSE) gl.GetRefinementInfoLogARK(program, sizeof(log), nullptr, log);
  t.require(built == GL_TRUE, std::string("the refinement program builds: ") + log);
}

void set_refinement_shader(Test& t, GLuint program, const std::string& source) {
  const char* const text = source.c_str();
  gl.RefinementShaderSourceARK(program, 1, &text, nullptr);
  require_refinable(t, program);
}

GLuint colour_program(Test& t) { return build_program(t, {.vertex = plain_vertex_shader}); }

}  // namespace glark::conformance
