// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What an application sets on a program for its next link. It may set it again after the link, so what the program was
// linked with is read right then.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glark/gl/dispatch.h"

namespace glark::core {

struct FeedbackVarying {
  std::string name;
  GLenum type;
  GLsizei size;  // number of array elements
};

struct LinkSettings {
  bool separable = false;
  GLenum feedback_mode = GL_INTERLEAVED_ATTRIBS;
  std::vector<FeedbackVarying> feedback_varyings;  // those of glTransformFeedbackVaryings
  // ARB_geometry_shader4: the parameters of `geometry_parameters`; -1: GL does not know it.
  std::array<GLint, 3> geometry = {-1, -1, -1};
};

inline constexpr std::array<GLenum, 3> geometry_parameters{GL_GEOMETRY_INPUT_TYPE_ARB, GL_GEOMETRY_OUTPUT_TYPE_ARB,
                                                           GL_GEOMETRY_VERTICES_OUT_ARB};

// Call right after the link. `old_geometry_shader`: a geometry shader is written for ARB_geometry_shader4.
LinkSettings read_link_settings(const gl::Dispatch& gl, GLuint program, bool old_geometry_shader);

}  // namespace glark::core
