// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/feedback/refined_feedback.h"

#include <algorithm>
#include <utility>

namespace glark::core {
namespace {

bool is_points_or_lines(GLenum mode) {
  return mode == GL_POINTS || mode == GL_LINES || mode == GL_LINE_LOOP || mode == GL_LINE_STRIP;
}

// The primitive type that transform feedback captures when triangles run through this program. GL_NONE: the program
// takes no triangles.
GLenum feedback_mode(const gl::Dispatch& gl, const Program& owner, GLuint derived) {
  if (!owner.has_stage(GL_GEOMETRY_SHADER)) {
    return GL_TRIANGLES;
  }
  GLint input = 0;
  GLint output = 0;
  gl.GetProgramiv(derived, GL_GEOMETRY_INPUT_TYPE, &input);
  gl.GetProgramiv(derived, GL_GEOMETRY_OUTPUT_TYPE, &output);
  if (input != GL_TRIANGLES) {
    return GL_NONE;
  }
  return output == GL_POINTS ? GL_POINTS : output == GL_LINE_STRIP ? GL_LINES : GL_TRIANGLES;
}

}  // namespace

void RefinedFeedback::set_program(std::shared_ptr<DerivedProgram> program) {
  in_use_.program = std::move(program);
  env_.state.bindings().transform_feedback.ours = in_use_.ours();
}

bool RefinedFeedback::begin_refined(GLenum mode, const DrawCall& call) {
  const Quiet quiet = env_.state.quiet();
  DrawCall planned = call;
  planned.tags_vary = env_.ark.depth_source == DepthSource::tag;  // they may in later draws
  const Decision decision = planner_.plan(planned, Planner::Purpose::feedback);
  const DrawPlan& plan = decision.plan;
  if (decision.cause || plan.pipeline != nullptr ||
      (plan.owner != nullptr ? feedback_mode(env_.gl, *plan.owner, plan.derived->name) : GL_TRIANGLES) != mode) {
    return false;
  }
  programs_.use_derived(*plan.derived, plan.pipeline);
  env_.gl.BeginTransformFeedback(mode);
  env_.gl.PauseTransformFeedback();
  programs_.use_application();
  set_program(plan.derived);
  in_use_.mode = mode;
  in_use_.owner = plan.owner != nullptr ? plan.owner->name : 0;
  in_use_.has_captured = false;
  return true;
}

void RefinedFeedback::hand_back() {
  if (!watches_draws() || in_use_.has_captured) {
    return;
  }
  env_.state.refresh();
  const Bindings& b = env_.bindings();
  if (b.transform_feedback.paused || !b.transform_feedback.active) {
    return;
  }
  awaited_.reset();
  if (!ours()) {
    return;
  }
  const Quiet quiet = env_.state.quiet();
  end_ours();
  set_program(nullptr);
  env_.gl.BeginTransformFeedback(in_use_.mode);
}

void RefinedFeedback::hand_back_for(GLenum draw_mode) {
  if (ours() && draw_mode <= GL_TRIANGLE_STRIP_ADJACENCY && !is_points_or_lines(draw_mode)) {
    hand_back();
  }
}

void RefinedFeedback::hand_back_at_begin(GLenum draw_mode) {
  const std::shared_ptr<Program> current = env_.state.programs().current();
  const bool captures_mode = current == nullptr || current->has_stage(GL_GEOMETRY_SHADER);
  if (awaited_.value_or(in_use_.mode) != GL_TRIANGLES || !is_points_or_lines(draw_mode) || captures_mode) {
    hand_back();
  }
}

bool RefinedFeedback::captures() const {
  const TransformFeedbackBindings& bound = env_.bindings().transform_feedback;
  return watches_draws() && bound.active && !bound.paused;
}

bool RefinedFeedback::refuses(GLenum mode) const {
  return ours() && captures() && is_points_or_lines(mode) && in_use_.mode == GL_TRIANGLES;
}

bool RefinedFeedback::refuses_link(GLuint program) const {
  const auto captures_from = [program](const FeedbackInUse& in_use) {
    return in_use.ours() && in_use.owner != 0 && in_use.owner == program;
  };
  return captures_from(in_use_) || std::any_of(waiting_.begin(), waiting_.end(), [&](const auto& waiting) {
           return captures_from(waiting.second.in_use);
         });
}

void RefinedFeedback::bound(GLuint previous, GLuint object) {
  if (object == previous) {
    return;
  }
  if (watches_draws()) {
    waiting_[previous] = {std::exchange(in_use_, {}), std::exchange(awaited_, std::nullopt)};
  }
  if (const auto found = waiting_.find(object); found != waiting_.end()) {
    in_use_ = std::move(found->second.in_use);
    awaited_ = found->second.awaited;
    waiting_.erase(found);
  }
  TransformFeedbackBindings& bound = env_.state.bindings().transform_feedback;
  bound.ours = ours();
  bound.paused = bound.paused || ours();
}

bool RefinedFeedback::can_return() const {
  const std::shared_ptr<Program> current = env_.state.programs().current();
  return env_.bindings().program == 0 ||
         (current != nullptr && current->linked && current->cause != Cause::program_gone);
}

void RefinedFeedback::end_ours() const {
  if (!can_return()) {
    env_.gl.EndTransformFeedback();
    return;
  }
  programs_.use_derived(*in_use_.program, nullptr);
  env_.gl.ResumeTransformFeedback();
  env_.gl.EndTransformFeedback();
  programs_.use_application();
}

void RefinedFeedback::end() {
  if (ours()) {
    env_.state.refresh();
  }
  if (ours() && env_.bindings().transform_feedback.active) {
    const Quiet quiet = env_.state.quiet();
    end_ours();
  } else {
    env_.gl.EndTransformFeedback();
  }
  set_program(nullptr);
  in_use_ = {};
  awaited_.reset();
}

void RefinedFeedback::take_over(const DrawCall& call) {
  if (!awaited_ || !env_.ark.enabled || call.never_refined || !is_triangle_mode(call.mode)) {
    return;
  }
  env_.state.refresh();
  const TransformFeedbackBindings& bound = env_.bindings().transform_feedback;
  if (!bound.active || bound.paused) {
    return;
  }
  const GLenum mode = *std::exchange(awaited_, std::nullopt);
  // Nothing has been captured: the feedback may begin again, with another program.
  env_.gl.EndTransformFeedback();
  env_.state.forget_bindings();
  if (!begin_refined(mode, call)) {
    env_.gl.BeginTransformFeedback(mode);
    awaited_ = mode;
  }
  env_.state.bindings().transform_feedback.active = true;
}

}  // namespace glark::core
