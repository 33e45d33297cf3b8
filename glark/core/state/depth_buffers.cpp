// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/depth_buffers.h"

namespace glark::core {

void DepthBuffers::look_up(const gl::Dispatch& gl, PendingError& errors) {
  if (const auto found = answers_.find(bound_); found != answers_.end()) {
    answer_ = found->second;
    return;
  }
  ErrorScope scope(errors);
  GLint bound = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  GLint type = GL_NONE;
  gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, bound == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT,
                                         GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  bound_ = static_cast<GLuint>(bound);
  answer_ = type != GL_NONE || scope.take() != GL_NO_ERROR ? Answer::yes : Answer::no;
  answers_[bound_] = answer_;
}

}  // namespace glark::core
