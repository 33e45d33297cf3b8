// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's transform feedback, when it enabled GL_ARK itself: it captures refined triangles.
#pragma once

#include "glark/core/feedback/feedback_room.h"
#include "glark/core/plan/feedback_in_use.h"
#include "glark/core/plan/planner.h"
#include "glark/core/state/environment.h"

namespace glark::core {

// After a call of a function that is not const, the caller updates what depends on watches_draws().
class RefinedFeedback {
 public:
  RefinedFeedback(const Environment& environment, FeedbackInUse& in_use, Planner& planner,
                  const ProgramSwitch& programs)
      : env_(environment), in_use_(in_use), planner_(planner), programs_(programs), room_(environment) {}

  // glBeginTransformFeedback. False: nothing was done.
  bool begin(GLenum mode);
  // The application began feedback while GL_ARK was disabled. If its first draw is glDrawARP, take_over() begins it again.
  void await(GLenum mode) { awaited_ = mode; }
  // Before a refined draw: takes over feedback that was awaited.
  void take_over();
  // Before a draw that stays as it is: gives the feedback to GL, unless it has captured refined triangles.
  void hand_back();
  void end();

  FeedbackRoom& room() { return room_; }

  bool ours() const { return in_use_.ours(); }
  bool watches_draws() const { return ours() || awaited_ != GL_NONE; }
  // Draws in this mode are an error. The driver does not see it, because we pause the feedback between our draws.
  bool refuses(GLenum mode) const;

 private:
  void set_program(std::shared_ptr<DerivedProgram> program);

  const Environment& env_;
  FeedbackInUse& in_use_;
  Planner& planner_;
  const ProgramSwitch& programs_;
  FeedbackRoom room_;
  GLenum awaited_ = GL_NONE;
};

}  // namespace glark::core
