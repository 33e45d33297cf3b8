// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "glark/gl/dispatch.h"

namespace glark::core {

// The name of a block, a variable or another resource of a linked program. Empty if there is none with this index.
inline std::string resource_name(const gl::Dispatch& gl, GLuint program, GLenum interface, GLuint index) {
  constexpr GLenum property = GL_NAME_LENGTH;
  GLint length = 0;  // with the final zero
  gl.GetProgramResourceiv(program, interface, index, 1, &property, 1, nullptr, &length);
  if (length <= 1) return {};
  std::string name(static_cast<std::size_t>(length), '\0');
  gl.GetProgramResourceName(program, interface, index, length, nullptr, name.data());
  name.pop_back();
  return name;
}

}  // namespace glark::core
