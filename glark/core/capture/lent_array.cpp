// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/lent_array.h"

namespace glark::capture {

void LentArray::lend(const gl::Dispatch& gl, core::ArrayState& arrays) const {
  const GLuint bound = arrays.bound_buffer(GL_ARRAY_BUFFER).name;
  gl.BindBuffer(GL_ARRAY_BUFFER, source.buffer);
  gl.VertexAttribPointer(attribute, source.size, source.type, source.normalized ? GL_TRUE : GL_FALSE, source.stride,
                         reinterpret_cast<const void*>(source.offset));
  gl.EnableVertexAttribArray(attribute);
  gl.BindBuffer(GL_ARRAY_BUFFER, bound);
}

void LentArray::take_back(const gl::Dispatch& gl, core::ArrayState& arrays) const {
  const GLuint bound = arrays.bound_buffer(GL_ARRAY_BUFFER).name;
  gl.DisableVertexAttribArray(attribute);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.VertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.BindBuffer(GL_ARRAY_BUFFER, bound);
}

}  // namespace glark::capture
