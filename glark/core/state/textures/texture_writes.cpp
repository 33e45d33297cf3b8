// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/textures/texture_writes.h"

namespace glark::core {

// Between glBegin and glEnd, GL answers no queries.
void TextureWrites::to_bound() {
  if (state_.immediate().open()) {
    to_any();
    return;
  }
  GLint texture = 0;
  gl_.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  textures_.wrote(static_cast<GLuint>(texture), state_.stamps().next());
}

}  // namespace glark::core
