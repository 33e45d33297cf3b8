// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/programs/link_settings.h"

#include <algorithm>

namespace glark::core {
namespace {

GLint parameter_of(const gl::Dispatch& gl, GLuint program, GLenum name, GLint otherwise) {
  gl.GetProgramiv(program, name, &otherwise);
  return otherwise;
}

std::vector<FeedbackVarying> read_varyings(const gl::Dispatch& gl, GLuint program) {
  const GLint count = parameter_of(gl, program, GL_TRANSFORM_FEEDBACK_VARYINGS, 0);
  const GLint longest = count > 0 ? parameter_of(gl, program, GL_TRANSFORM_FEEDBACK_VARYING_MAX_LENGTH, 0) : 0;
  std::vector<char> name(static_cast<std::size_t>(std::max(longest, 0)) + 1);
  std::vector<FeedbackVarying> varyings;
  for (GLint i = 0; i < count; ++i) {
    FeedbackVarying varying{};
    gl.GetTransformFeedbackVarying(program, static_cast<GLuint>(i), static_cast<GLsizei>(name.size()), nullptr,
                                   &varying.size, &varying.type, name.data());
    varying.name = name.data();
    varyings.push_back(std::move(varying));
  }
  return varyings;
}

}  // namespace

LinkSettings read_link_settings(const gl::Dispatch& gl, GLuint program, bool old_geometry_shader) {
  LinkSettings settings{
      .separable = parameter_of(gl, program, GL_PROGRAM_SEPARABLE, GL_FALSE) != GL_FALSE,
      .feedback_mode =
          static_cast<GLenum>(parameter_of(gl, program, GL_TRANSFORM_FEEDBACK_BUFFER_MODE, GL_INTERLEAVED_ATTRIBS)),
      .feedback_varyings = read_varyings(gl, program),
  };
  for (std::size_t i = 0; i < geometry_parameters.size() && old_geometry_shader; ++i) {
    settings.geometry[i] = parameter_of(gl, program, geometry_parameters[i], -1);
  }
  return settings;
}

}  // namespace glark::core
