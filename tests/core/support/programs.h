// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Programs and buffers in one call each.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/core/support/gl.h"

namespace glark::core::test {

struct ProgramSources {
  std::string vertex = {};
  std::string fragment = {};
  std::vector<const char*> varyings = {};    // captured, interleaved
  std::vector<const char*> attributes = {};  // bound to locations 0, 1, ...
  std::string geometry = {};
};

inline void attach_shader(GLuint program, GLenum stage, const std::string& source) {
  if (source.empty()) return;
  const GLuint shader = glCreateShader(stage);
  const char* const text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  EXPECT_EQ(compiled, GL_TRUE) << log.data() << source;
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

inline GLuint link_program(const ProgramSources& sources) {
  const GLuint program = glCreateProgram();
  attach_shader(program, GL_VERTEX_SHADER, sources.vertex);
  attach_shader(program, GL_GEOMETRY_SHADER, sources.geometry);
  attach_shader(program, GL_FRAGMENT_SHADER, sources.fragment);
  if (!sources.varyings.empty()) {
    glTransformFeedbackVaryings(program, static_cast<GLsizei>(sources.varyings.size()), sources.varyings.data(),
                                GL_INTERLEAVED_ATTRIBS);
  }
  for (std::size_t i = 0; i < sources.attributes.size(); ++i) {
    glBindAttribLocation(program, static_cast<GLuint>(i), sources.attributes[i]);
  }
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  std::array<char, 1024> log{};
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  EXPECT_EQ(linked, GL_TRUE) << log.data();
  return program;
}

template <typename Value>
GLuint make_buffer(GLenum target, const std::vector<Value>& data, GLenum usage = GL_STATIC_DRAW) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(Value)), data.data(), usage);
  return buffer;
}

inline const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

// A float attribute, tightly packed, from the buffer bound to GL_ARRAY_BUFFER.
inline void float_attribute(GLuint location, GLint components) {
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(location);
}

}  // namespace glark::core::test
