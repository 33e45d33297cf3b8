// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/programs/shader.h"

#include <array>
#include <vector>

#include "glark/core/report/log.h"

namespace glark::core {
namespace {

using LogText = std::array<char, 2048>;

}  // namespace

std::string idle_fragment_shader(bool es) {
  return std::string(es ? "#version 320 es\n" : "#version 430\n") + "void main() {}\n";
}

GLuint compile_shader(const gl::Dispatch& gl, GLenum stage, const std::string& source, std::string& error) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    LogText text_of_log{};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(text_of_log.size()), nullptr, text_of_log.data());
    error += text_of_log.data();
    log(LogLevel::debug, "this shader of glark does not compile:\n" + source);
  }
  return shader;
}

bool link_program(const gl::Dispatch& gl, GLuint program, std::span<const GLuint> shaders, std::string& error) {
  for (const GLuint shader : shaders) {
    gl.AttachShader(program, shader);
  }
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  for (const GLuint shader : shaders) {
    gl.DetachShader(program, shader);
    gl.DeleteShader(shader);
  }
  if (linked != GL_FALSE) {
    return true;
  }
  LogText text_of_log{};
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(text_of_log.size()), nullptr, text_of_log.data());
  error += text_of_log.data();
  gl.DeleteProgram(program);
  return false;
}

GLuint build_program(const gl::Dispatch& gl, const std::string& what, std::span<const ShaderText> texts,
                     std::span<const std::string> varyings) {
  std::string error;
  const GLuint program = gl.CreateProgram();
  std::vector<GLuint> shaders;
  for (const ShaderText& text : texts) {
    shaders.push_back(compile_shader(gl, text.stage, text.source, error));
  }
  std::vector<const char*> names;
  for (const std::string& varying : varyings) {
    names.push_back(varying.c_str());
  }
  if (!names.empty()) {
    gl.TransformFeedbackVaryings(program, static_cast<GLsizei>(names.size()), names.data(), GL_INTERLEAVED_ATTRIBS);
  }
  if (link_program(gl, program, shaders, error)) {
    return program;
  }
  log(LogLevel::error, what + " cannot be built: " + error);
  return 0;
}

}  // namespace glark::core
