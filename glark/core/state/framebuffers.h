// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which framebuffers have a depth buffer and draw colours, and which stencil buffer they have. Without a depth buffer, GL
// neither tests nor writes depth, even with GL_DEPTH_TEST. A shadow map has no colours. GL is asked once for each
// framebuffer, and again after its attachments or draw buffers have changed.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "glark/core/objects/error_scope.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class Framebuffers {
 public:
  // glBindFramebuffer for drawing.
  void bind(GLuint framebuffer) {
    bound_ = framebuffer;
    answer_ = nullptr;
  }
  // The attachments or draw buffers of framebuffers may have changed.
  void forget_attachments() {
    if (!answers_.empty()) {
      answers_.clear();
      answer_ = nullptr;
    }
  }
  // The default framebuffer may be another one.
  void forget_default() {
    answers_.erase(0);
    answer_ = nullptr;
  }

  GLuint bound_name() const { return bound_; }
  // Returns whether the bound framebuffer has a depth buffer. True also if GL does not say.
  bool bound_has_depth(const gl::Dispatch& gl, PendingError& errors) { return bound(gl, errors).depth; }
  // Returns whether draws write to a colour buffer of the bound framebuffer. True also if GL does not say.
  bool bound_has_colors(const gl::Dispatch& gl, PendingError& errors) { return bound(gl, errors).colors; }

  // Names the stencil buffer of the bound framebuffer: another framebuffer may have the same one. 0: it has none.
  std::uint64_t bound_stencil(const gl::Dispatch& gl, PendingError& errors) { return bound(gl, errors).stencil; }

  static constexpr std::uint64_t unknown_stencil = 1;  // GL does not say
  static constexpr std::uint64_t window_stencil = 2;

 private:
  struct Answer {
    bool depth = true;
    bool colors = true;
    std::uint64_t stencil = unknown_stencil;
  };
  const Answer& bound(const gl::Dispatch& gl, PendingError& errors) {
    if (answer_ == nullptr) {
      look_up(gl, errors);
    }
    return *answer_;
  }
  void look_up(const gl::Dispatch& gl, PendingError& errors);

  std::unordered_map<GLuint, Answer> answers_;  // of framebuffers that exist
  GLuint bound_ = 0;                            // GL has accepted it if it has an answer
  const Answer* answer_ = nullptr;              // of the bound framebuffer; null: unknown
};

}  // namespace glark::core
