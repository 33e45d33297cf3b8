// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/textures/texture_bindings.h"

namespace glark::core {

void TextureBindings::read(const gl::Dispatch& gl, GLuint unit) {
  GLint active = GL_TEXTURE0;
  GLint texture = 0;
  GLint sampler = 0;
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  gl.GetIntegerv(GL_SAMPLER_BINDING, &sampler);
  gl.ActiveTexture(static_cast<GLenum>(active));
  found_ = {static_cast<GLuint>(texture), static_cast<GLuint>(sampler)};
  unit_ = unit;
  read_at_ = changes_;
}

}  // namespace glark::core
