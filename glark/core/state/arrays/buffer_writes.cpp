// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/arrays/buffer_writes.h"

namespace glark::core {

void BufferWrites::to_asked(GLenum target) {
  const BoundBuffer bound = arrays_.bound_buffer(target);
  bound.known ? to_buffer(bound.name) : buffers_.wrote_any(stamps_.next());
}

}  // namespace glark::core
