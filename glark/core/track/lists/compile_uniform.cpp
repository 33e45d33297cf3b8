// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/track/lists/compile_uniform.h"

#include "glark/core/track/complain.h"

namespace glark::core::track {

void compile_uniform(Context& context, const char* function, GLint location) {
  if (location < virtual_location_base) {
    context.state().lists().note_uniforms();
  } else {
    complain(context, GL_INVALID_OPERATION, function,
             "display lists do not take uniforms of refinement shaders; set them before the list is called");
  }
}

}  // namespace glark::core::track
