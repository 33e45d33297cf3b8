// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/core/capture/capture.h"
#include "glark/core/state/bindings.h"
#include "glark/gl/dispatch.h"

namespace glark::capture {

// Binds an idle transform feedback object while it lives: GL does not link a program with varyings while the bound
// object is active, even if it is paused.
class FeedbackAside {
 public:
  FeedbackAside(const gl::Dispatch& gl, CaptureStage& capture, const core::Bindings& bindings)
      : gl_(gl), bindings_(bindings) {
    if (bindings_.transform_feedback.active) {
      gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, capture.feedback());
    }
  }
  ~FeedbackAside() {
    if (bindings_.transform_feedback.active) {
      gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, bindings_.transform_feedback.object);
    }
  }
  FeedbackAside(const FeedbackAside&) = delete;
  FeedbackAside& operator=(const FeedbackAside&) = delete;

 private:
  const gl::Dispatch& gl_;
  const core::Bindings& bindings_;
};

}  // namespace glark::capture
