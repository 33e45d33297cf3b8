// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of the application's transform feedback.
#include "glark/core/track/track.h"

namespace glark::core {

bool track::refused_while_capturing(Context& c) {
  if (c.stages() == nullptr || !c.stages()->feedback().watches_draws() || c.state().lists().compiling()) {
    return false;
  }
  c.state().refresh();
  if (!c.stages()->feedback().captures()) {
    return false;
  }
  c.pending_error().raise(GL_INVALID_OPERATION);
  return true;
}

namespace hook {

void BindTransformFeedback(Context& c, GLenum target, GLuint id) {
  if (track::refused_while_capturing(c)) {
    return;
  }
  if (c.stages() == nullptr) {
    c.gl().BindTransformFeedback(target, id);
    c.state().forget_bindings();  // another object may be active or paused
    return;
  }
  c.state().refresh();
  const GLuint previous = c.state().bindings().transform_feedback.object;
  c.gl().BindTransformFeedback(target, id);
  c.state().forget_bindings();
  c.state().refresh();
  c.stages()->feedback().bound(previous, c.state().bindings().transform_feedback.object);
  c.state().forget_bindings();
  c.update_refining();
}

void DeleteTransformFeedbacks(Context& c, GLsizei n, const GLuint* ids) {
  c.gl().DeleteTransformFeedbacks(n, ids);
  c.state().forget_bindings();
}

void BeginTransformFeedback(Context& c, GLenum mode) {
  if (!c.capabilities().refinable) {
    c.gl().BeginTransformFeedback(mode);
    c.state().forget_bindings();
    return;
  }
  c.state().refresh();
  if (c.state().bindings().transform_feedback.active) {
    c.pending_error().raise(GL_INVALID_OPERATION);
    return;
  }
  c.gl().BeginTransformFeedback(mode);
  c.state().forget_bindings();
  c.state().refresh();
  if (!c.state().bindings().transform_feedback.active) {
    return;  // GL has refused
  }
  RefinedFeedback& feedback = c.stages()->feedback();
  feedback.room().note();
  if (!c.options().transparent && c.ark().pool_level >= 0) {
    feedback.await(mode);
    c.update_refining();
  }
}

void EndTransformFeedback(Context& c) {
  if (c.stages() != nullptr) {
    c.stages()->feedback().end();
    c.update_refining();
  } else {
    c.gl().EndTransformFeedback();
  }
  c.writes().by_gpu();
  c.state().forget_bindings();
}

void PauseTransformFeedback(Context& c) {
  if (c.stages() != nullptr && c.stages()->feedback().ours() && !c.state().bindings().transform_feedback.paused) {
    c.state().bindings().transform_feedback.paused = true;  // between our draws it is already paused
    c.writes().by_gpu();                                    // what it captured may be drawn now
    return;
  }
  c.gl().PauseTransformFeedback();
  c.writes().by_gpu();
  c.state().forget_bindings();
}

void ResumeTransformFeedback(Context& c) {
  if (c.stages() != nullptr && c.stages()->feedback().ours() && c.state().bindings().transform_feedback.paused) {
    c.state().refresh();
    if (c.stages()->feedback().refuses_resume(c.state().bindings().program)) {
      c.pending_error().raise(GL_INVALID_OPERATION);
    } else {
      c.state().bindings().transform_feedback.paused = false;
    }
    return;
  }
  c.gl().ResumeTransformFeedback();
  c.state().forget_bindings();
}

}  // namespace hook
}  // namespace glark::core
