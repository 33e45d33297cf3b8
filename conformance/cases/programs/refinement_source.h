// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sources of refinement shaders and their properties.
#pragma once

#include <cstring>

#include "conformance/gl/gl.h"

namespace glark::conformance {

inline GLint property(GLuint program, GLenum name) {
  GLint value = -7;
  gl.GetRefinementivARK(program, name, &value);
  return value;
}

inline GLint source_length(GLuint program) { return property(program, GL_REFINEMENT_SOURCE_LENGTH_ARK); }

inline void give(GLuint program, const char* source) { gl.RefinementShaderSourceARK(program, 1, &source, nullptr); }

inline GLint length_of(const char* source) { return static_cast<GLint>(std::strlen(source)) + 1; }

}  // namespace glark::conformance
