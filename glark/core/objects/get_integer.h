// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/gl/dispatch.h"

namespace glark::core {

// A state of GL that is one integer. 0 if GL does not know the name.
inline GLint get_integer(const gl::Dispatch& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

}  // namespace glark::core
