// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/framebuffers.h"

namespace glark::core {
namespace {

constexpr GLenum draw_buffers = 8;  // the minimum of GL_MAX_DRAW_BUFFERS

bool has_attachment(const gl::Dispatch& gl, GLenum attachment) {
  GLint type = GL_NONE;
  gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  return type != GL_NONE;
}

bool has_color(const gl::Dispatch& gl, GLint framebuffer) {
  for (GLenum i = 0; i < draw_buffers; ++i) {
    GLint buffer = GL_NONE;
    gl.GetIntegerv(GL_DRAW_BUFFER0 + i, &buffer);
    if (buffer != GL_NONE && (framebuffer == 0 || has_attachment(gl, static_cast<GLenum>(buffer)))) {
      return true;
    }
  }
  return false;
}

}  // namespace

void Framebuffers::look_up(const gl::Dispatch& gl, PendingError& errors) {
  if (const auto found = answers_.find(bound_); found != answers_.end()) {
    answer_ = found->second;
    return;
  }
  ErrorScope scope(errors);
  GLint bound = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const bool depth = has_attachment(gl, bound == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT);
  const bool color = has_color(gl, bound);
  const bool answered = scope.take() == GL_NO_ERROR;
  bound_ = static_cast<GLuint>(bound);
  answer_ = {true, depth || !answered, color || !answered};
  answers_[bound_] = answer_;
}

}  // namespace glark::core
