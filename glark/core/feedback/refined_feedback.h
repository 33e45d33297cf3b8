// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's transform feedback, if the application uses the extension itself: it captures refined triangles.
// GL begins it with the application's program, and so finds all errors. It begins again, with a program of ours, at the
// first refined draw, unless it has captured something by then.
#pragma once

#include <optional>
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

  // GL has begun the application's feedback.
  void await(GLenum mode) { awaited_ = mode; }
  // Another feedback object is bound. The feedback of `previous`, if it is active, is paused.
  void bound(GLuint previous, GLuint object);
  // Before a draw that may be refined.
  void take_over(const DrawCall& call);
  // Before unrefined draws: leaves the feedback to GL, unless it has captured refined triangles.
  void hand_back();
  // The same before one draw, which GL may refuse. If awaits(), the caller calls hand_back() after a draw that GL did not
  // refuse.
  void hand_back_for(GLenum draw_mode);
  // Before an unrefined glBegin.
  void hand_back_at_begin(GLenum draw_mode);
  bool awaits() const { return awaited_.has_value(); }
  // glEndTransformFeedback. Resumes ours first: NVIDIA (580) takes a feedback that ends while it is paused and another
  // program is in use for one that goes on, and then refuses to link programs.
  void end();

  FeedbackRoom& room() { return room_; }

  bool ours() const { return in_use_.ours(); }
  bool watches_draws() const { return ours() || awaited_.has_value(); }
  // The driver cannot see the errors of an active feedback, because we pause ours between our draws. These return
  // whether there is one: a draw in this mode; a call that needs a paused feedback; linking this program; resuming the
  // feedback while this program is in use.
  bool refuses(GLenum mode) const;
  bool captures() const;
  bool refuses_link(GLuint program) const;
  bool refuses_resume(GLuint program) const { return ours() && in_use_.owner != program; }

 private:
  // The feedback of an object that is not bound.
  struct Waiting {
    FeedbackInUse in_use;
    std::optional<GLenum> awaited;
  };

  // Begins the feedback with the derived program of the draw. Does nothing and returns false if there is none.
  bool begin_refined(GLenum mode, const DrawCall& call);
  // Returns whether the program in use can be bound again after another one.
  bool can_return() const;
  void end_ours() const;
  void set_program(std::shared_ptr<DerivedProgram> program);

  const Environment& env_;
  FeedbackInUse& in_use_;
  Planner& planner_;
  const ProgramSwitch& programs_;
  FeedbackRoom room_;
  std::optional<GLenum> awaited_;  // the mode of a feedback that GL has begun, and that captured nothing yet
  std::unordered_map<GLuint, Waiting> waiting_;  // by transform feedback object
};

}  // namespace glark::core
