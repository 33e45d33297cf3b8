// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which framebuffers have a depth buffer, and which ones take colours. Without a depth buffer, GL neither tests nor writes
// depth, even with GL_DEPTH_TEST. GL is asked once for each framebuffer, and again after its attachments have changed.
#pragma once

#include <unordered_map>

#include "glark/core/objects/error_scope.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class Framebuffers {
 public:
  // glBindFramebuffer for drawing.
  void bind(GLuint framebuffer) {
    bound_ = framebuffer;
    answer_.known = false;
  }
  // The attachments or the draw buffers of framebuffers may have changed.
  void forget_attachments() {
    if (!answers_.empty()) {
      answers_.clear();
      answer_.known = false;
    }
  }
  // The default framebuffer may be another one.
  void forget_default() {
    answers_.erase(0);
    answer_.known = false;
  }

  // Return whether the bound framebuffer has a depth buffer, and whether fragments can change a colour in it. True also
  // if GL does not say.
  bool bound_has_depth(const gl::Dispatch& gl, PendingError& errors) { return bound(gl, errors).depth; }
  bool bound_has_color(const gl::Dispatch& gl, PendingError& errors) { return bound(gl, errors).color; }

 private:
  struct Answer {
    bool known = false;
    bool depth = true;
    bool color = true;
  };
  const Answer& bound(const gl::Dispatch& gl, PendingError& errors) {
    if (!answer_.known) {
      look_up(gl, errors);
    }
    return answer_;
  }
  void look_up(const gl::Dispatch& gl, PendingError& errors);

  std::unordered_map<GLuint, Answer> answers_;  // of framebuffers that exist
  GLuint bound_ = 0;                            // GL has accepted it if it has an answer
  Answer answer_;                               // of the bound framebuffer
};

}  // namespace glark::core
