// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/application_message.h"

namespace glark::core {

// GL_DEBUG_SOURCE_API is for the driver only: glDebugMessageInsert accepts two sources, and we are a third party.
void DebugOutput::send(MessageId id, const std::string& text) const {
  if (!audible) {
    return;
  }
  const bool error = id == MessageId::wrong_call;
  if (hushed) {
    gl.Enable(GL_DEBUG_OUTPUT);
  }
  gl.DebugMessageInsert(GL_DEBUG_SOURCE_THIRD_PARTY, error ? GL_DEBUG_TYPE_ERROR : GL_DEBUG_TYPE_OTHER,
                        static_cast<GLuint>(id), error ? GL_DEBUG_SEVERITY_HIGH : GL_DEBUG_SEVERITY_MEDIUM,
                        static_cast<GLsizei>(text.size()), text.data());
  if (hushed) {
    gl.Disable(GL_DEBUG_OUTPUT);
  }
}

}  // namespace glark::core
