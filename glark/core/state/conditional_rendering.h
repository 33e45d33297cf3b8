// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's conditional rendering. It decides whether a draw is seen, but not whether our passes run: what they
// count and keep must hold for later draws, too.
#pragma once

#include <utility>

#include "glark/gl/dispatch.h"

namespace glark::core {

class ConditionalRendering {
 public:
  // GL has accepted glBeginConditionalRender, or glEndConditionalRender.
  void begin(GLuint query, GLenum mode) {
    query_ = query;
    mode_ = mode;
  }
  void end() { query_ = 0; }
  // Without its query, conditional rendering cannot begin again.
  void query_deleted(GLuint query) { query_ = query == query_ ? 0 : query_; }
  // A display list has compiled one of the commands: nobody sees when it takes effect.
  void lose() { followed_ = false; }

  // Ends conditional rendering for our own calls. False: there is none, or it has ended already.
  bool lift(const gl::Dispatch& gl) {
    if (query_ == 0 || lifted_ || !followed_) {
      return false;
    }
    gl.EndConditionalRender();
    return lifted_ = true;
  }
  // Begins it again. False: it was not lifted.
  bool apply(const gl::Dispatch& gl) {
    if (!std::exchange(lifted_, false)) {
      return false;
    }
    gl.BeginConditionalRender(query_, mode_);
    return true;
  }

 private:
  GLuint query_ = 0;  // 0: none is active
  GLenum mode_ = GL_QUERY_WAIT;
  bool followed_ = true;
  bool lifted_ = false;
};

// While it lives, GL draws unconditionally. Where conditional rendering was lifted before, it ends that.
class ConditionLifted {
 public:
  ConditionLifted(ConditionalRendering& condition, const gl::Dispatch& gl) : condition_(condition), gl_(gl) {
    condition_.lift(gl_);
  }
  ~ConditionLifted() { condition_.apply(gl_); }
  ConditionLifted(const ConditionLifted&) = delete;
  ConditionLifted& operator=(const ConditionLifted&) = delete;

 private:
  ConditionalRendering& condition_;
  const gl::Dispatch& gl_;
};

// While it lives, the condition decides again.
class ConditionApplied {
 public:
  ConditionApplied(ConditionalRendering& condition, const gl::Dispatch& gl)
      : condition_(condition), gl_(gl), applied_(condition.apply(gl)) {}
  ~ConditionApplied() {
    if (applied_) {
      condition_.lift(gl_);
    }
  }
  ConditionApplied(const ConditionApplied&) = delete;
  ConditionApplied& operator=(const ConditionApplied&) = delete;

 private:
  ConditionalRendering& condition_;
  const gl::Dispatch& gl_;
  bool applied_;
};

}  // namespace glark::core
