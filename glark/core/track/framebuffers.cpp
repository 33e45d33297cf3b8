// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of calls that choose the framebuffer to draw to.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

void follow_framebuffer(Context& c, GLenum target, GLuint framebuffer) {
  if (target == GL_FRAMEBUFFER || target == GL_DRAW_FRAMEBUFFER) {
    c.state().framebuffer_bound(framebuffer);
  }
}

}  // namespace

namespace hook {

void BindFramebuffer(Context& c, GLenum target, GLuint framebuffer) {
  c.gl().BindFramebuffer(target, framebuffer);
  follow_framebuffer(c, target, framebuffer);
}

void BindFramebufferEXT(Context& c, GLenum target, GLuint framebuffer) {
  c.gl().BindFramebufferEXT(target, framebuffer);
  follow_framebuffer(c, target, framebuffer);
}

}  // namespace hook
}  // namespace glark::core
