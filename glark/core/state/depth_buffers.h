// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which framebuffers have a depth buffer. Without one, GL neither tests nor writes depth, even with GL_DEPTH_TEST. GL is
// asked once for each framebuffer, and again after its attachments have changed.
#pragma once

#include <unordered_map>

#include "glark/core/objects/error_scope.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class DepthBuffers {
 public:
  // glBindFramebuffer for drawing.
  void bind(GLuint framebuffer) {
    bound_ = framebuffer;
    answer_ = Answer::unknown;
  }
  // The attachments of framebuffers may have changed.
  void forget_attachments() {
    if (!answers_.empty()) {
      answers_.clear();
      answer_ = Answer::unknown;
    }
  }
  // The default framebuffer may be another one.
  void forget_default() {
    answers_.erase(0);
    answer_ = Answer::unknown;
  }

  // Returns whether the bound framebuffer has a depth buffer. True also if GL does not say.
  bool bound_has_one(const gl::Dispatch& gl, PendingError& errors) {
    if (answer_ == Answer::unknown) {
      look_up(gl, errors);
    }
    return answer_ == Answer::yes;
  }

 private:
  enum class Answer { unknown, yes, no };
  void look_up(const gl::Dispatch& gl, PendingError& errors);

  std::unordered_map<GLuint, Answer> answers_;  // of framebuffers that exist
  GLuint bound_ = 0;                            // GL has accepted it if it has an answer
  Answer answer_ = Answer::unknown;             // of the bound framebuffer
};

}  // namespace glark::core
