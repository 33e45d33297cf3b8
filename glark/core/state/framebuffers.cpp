// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/framebuffers.h"

namespace glark::core {
namespace {

// The type of an attachment of the bound framebuffer; GL_NONE: there is none.
GLint attachment_type(const gl::Dispatch& gl, GLenum attachment) {
  GLint type = GL_NONE;
  gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  return type;
}

// Renderbuffers and textures may have the same names.
std::uint64_t stencil_of(const gl::Dispatch& gl, GLint framebuffer) {
  const GLint type = attachment_type(gl, framebuffer == 0 ? GL_STENCIL : GL_STENCIL_ATTACHMENT);
  if (type == GL_NONE || framebuffer == 0) {
    return type == GL_NONE ? 0 : Framebuffers::window_stencil;
  }
  GLint name = 0;
  gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT,
                                         GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
  return static_cast<std::uint64_t>(type) << 32U | static_cast<GLuint>(name);
}

// Draw buffer 0 stands for all of them. Window systems' framebuffers have colours.
bool draws_colors(const gl::Dispatch& gl, GLint framebuffer) {
  GLint buffer = GL_NONE;
  gl.GetIntegerv(GL_DRAW_BUFFER0, &buffer);
  return buffer != GL_NONE && (framebuffer == 0 || attachment_type(gl, static_cast<GLenum>(buffer)) != GL_NONE);
}

}  // namespace

void Framebuffers::look_up(const gl::Dispatch& gl, PendingError& errors) {
  if (const auto found = answers_.find(bound_); found != answers_.end()) {
    answer_ = &found->second;
    return;
  }
  ErrorScope scope(errors);
  GLint bound = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  const bool depth = attachment_type(gl, bound == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT) != GL_NONE;
  const bool colors = draws_colors(gl, bound);
  const std::uint64_t stencil = stencil_of(gl, bound);
  const bool unknown = scope.take() != GL_NO_ERROR;
  bound_ = static_cast<GLuint>(bound);
  answer_ = &(answers_[bound_] = {depth || unknown, colors || unknown, unknown ? unknown_stencil : stencil});
}

}  // namespace glark::core
