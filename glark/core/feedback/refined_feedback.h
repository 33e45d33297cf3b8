// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's transform feedback, if the application enabled GL_ARK itself: it captures refined triangles.
#pragma once

#include <unordered_map>

#include "glark/core/feedback/feedback_room.h"
#include "glark/core/plan/feedback_in_use.h"
#include "glark/core/plan/planner.h"
#include "glark/core/state/environment.h"

namespace glark::core {

// After a call of a non-const function, the caller updates the state that depends on watches_draws().
class RefinedFeedback {
 public:
  RefinedFeedback(const Environment& environment, FeedbackInUse& in_use, Planner& planner,
                  const ProgramSwitch& programs)
      : env_(environment), in_use_(in_use), planner_(planner), programs_(programs), room_(environment) {}

  // glBeginTransformFeedback. False: nothing was done.
  bool begin(GLenum mode);
  // The application began feedback while GL_ARK was disabled. If its first draw is glDrawARP, take_over() begins it
  // again.
  void await(GLenum mode) { awaited_ = mode; }
  // Another feedback object is bound. The feedback of `previous`, if it is active, is paused.
  void bound(GLuint previous, GLuint object);
  // Before a refined draw: takes over awaited feedback.
  void take_over();
  // Before an unrefined draw: gives the feedback to GL, unless it has captured refined triangles.
  void hand_back();
  // glEndTransformFeedback. Resumes ours first: NVIDIA (580) takes a feedback that ends while it is paused and another
  // program is in use for one that goes on, and then refuses to link programs.
  void end();

  FeedbackRoom& room() { return room_; }

  bool ours() const { return in_use_.ours(); }
  bool watches_draws() const { return ours() || awaited_ != GL_NONE; }
  // The driver cannot see the errors of an active feedback, because we pause ours between our draws. These return
  // whether there is one: a draw in this mode; a call that needs a paused feedback; linking this program.
  bool refuses(GLenum mode) const;
  bool captures() const { return in_use_.captures(env_.bindings()) && env_.bindings().transform_feedback.active; }
  bool refuses_link(GLuint program) const;

 private:
  // The feedback of an object that is not bound.
  struct Waiting {
    FeedbackInUse in_use;
    GLenum awaited = GL_NONE;
  };

  // Returns whether the program in use can be bound again after another one.
  bool can_return() const;
  void end_ours() const;
  void set_program(std::shared_ptr<DerivedProgram> program);

  const Environment& env_;
  FeedbackInUse& in_use_;
  Planner& planner_;
  const ProgramSwitch& programs_;
  FeedbackRoom room_;
  GLenum awaited_ = GL_NONE;
  std::unordered_map<GLuint, Waiting> waiting_;  // by transform feedback object
};

}  // namespace glark::core
