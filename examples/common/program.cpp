// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#define GL_GLEXT_PROTOTYPES
#include "examples/common/program.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <GL/glark.h>

#include <stdexcept>

namespace lesson {
namespace {

GLuint compile(GLenum stage, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  char log[4096] = "";
  glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
  throw std::runtime_error((stage == GL_VERTEX_SHADER ? "vertex shader: " : "fragment shader: ") + std::string(log));
}

}  // namespace

unsigned make_program(const std::string& vertex_shader, const std::string& fragment_shader,
                      const std::vector<const char*>& attributes) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER, vertex_shader));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment_shader));
  for (std::size_t i = 0; i < attributes.size(); ++i)
    glBindAttribLocation(program, static_cast<GLuint>(i), attributes[i]);
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  char log[4096] = "";
  glGetProgramInfoLog(program, sizeof(log), nullptr, log);
  throw std::runtime_error("program: " + std::string(log));
}

void set_refinement_shader(unsigned program, const std::string& source) {
  const char* const text = source.c_str();
  glRefinementShaderSourceARK(program, 1, &text, nullptr);
  GLint built = GL_FALSE;
  glGetRefinementivARK(program, GL_REFINEMENT_STATUS_ARK, &built);
  if (built == GL_TRUE) return;
  char log[4096] = "";
  glGetRefinementInfoLogARK(program, sizeof(log), nullptr, log);
  throw std::runtime_error(log);
}

void set_uniform(unsigned program, const char* name, float value) {
  glUniform1f(glGetUniformLocation(program, name), value);
}

void set_uniform(unsigned program, const char* name, float x, float y, float z) {
  glUniform3f(glGetUniformLocation(program, name), x, y, z);
}

void set_uniform_matrix(unsigned program, const char* name, const float* columns) {
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, columns);
}

unsigned make_buffer(unsigned target, const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

}  // namespace lesson
