// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/error_scope.h"

#include <utility>

namespace glark::core {

GLenum PendingError::take() { return std::exchange(error_, GL_NO_ERROR); }

ErrorScope::ErrorScope(PendingError& pending) : gl_(pending.gl_) { pending.raise(take()); }

GLenum ErrorScope::take() {
  GLenum first = GL_NO_ERROR;
  for (GLenum error = gl_.GetError(); error != GL_NO_ERROR; error = gl_.GetError()) {
    first = first == GL_NO_ERROR ? error : first;
    if (error == GL_CONTEXT_LOST) {
      break;
    }
  }
  return first;
}

ErrorScope::~ErrorScope() { take(); }

}  // namespace glark::core
