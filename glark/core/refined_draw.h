// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A draw call from end to end. Each step is a stage in a folder of its own:
//   plan/ -> keep/ -> capture/ -> weld/ -> polygons/ -> depth/ -> submit/
// A draw that cannot be refined leaves after plan/. A kept draw goes straight to submit/, perhaps with
// the refined vertices of evaluate/. RefinedDraw owns the stages that nobody else asks.
#pragma once

#include <cstdint>

#include "glark/core/capture/draw_call.h"
#include "glark/core/capture/draw_capture.h"
#include "glark/core/evaluate/evaluation.h"
#include "glark/core/feedback/refined_feedback.h"
#include "glark/core/immediate/immediate_capture.h"
#include "glark/core/keep/kept_draws.h"
#include "glark/core/keep/repeated_draws.h"
#include "glark/core/live/frame_watch.h"
#include "glark/core/live/half_window.h"
#include "glark/core/live/watched_draw.h"
#include "glark/core/meshes/mesh_watch.h"
#include "glark/core/passes/kept_views.h"
#include "glark/core/passes/triangle_passes.h"
#include "glark/core/pattern/pool_in_use.h"
#include "glark/core/plan/planner.h"
#include "glark/core/report/cause.h"
#include "glark/core/report/draw_classes.h"
#include "glark/core/report/passed_draws.h"
#include "glark/core/state/environment.h"
#include "glark/core/submit/submission.h"

namespace glark::core {

class RefinedDraw {
 public:
  struct Parts {
    const pattern::PoolInUse& pool;
    Planner& planner;
    capture::DrawCapture& capture;
    KeptDraws& kept;
    DrawPrograms& programs;
    TrianglePasses& passes;
    FeedbackInUse& feedback_in_use;
    RefinedFeedback& feedback;
    MeshWatch& meshes;
  };
  RefinedDraw(const Environment& environment, const Parts& parts);

  // Draws refined or unrefined, and counts the draw.
  void run(const DrawCall& call);
  // glBegin in a triangle mode. Returns how many triangles fit until glEnd, at least `least`; 0 means that the caller
  // begins unrefined.
  std::uint64_t begin_immediate(GLenum mode, MaterialSet materials, std::uint64_t least);
  void end_immediate(std::uint64_t triangles);
  // glEnd of a draw that began unrefined.
  void end_unrefined(std::uint64_t triangles);
  // Call before a draw whose number of vertices transform feedback has counted.
  void begin_counted() { submission_.flush_indirect(); }
  // Issues the draw unrefined.
  void leave(const DrawCall& call, Cause cause);
  void frame_finished();
  // Deletes all GL objects; only while the context is current.
  void release();
  const FrameWatch& watch() const { return watch_; }

 private:
  // Counts, tints and asks as the user wishes who watches the draws; empty if nobody does.
  using Watched = std::optional<WatchedDraw>;
  void watch(Watched& watched, const DrawPlan& plan, std::optional<Cause> cause, std::uint64_t triangles,
             bool kept = false);
  DrawClassKey class_of(const DrawPlan& plan, std::optional<Cause> cause) const;
  void draw_left_half(const HalfWindow& half, const DrawCall& call, const Quiet& quiet) const;
  void pass(Cause cause);
  void draw_as_asked(const DrawCall& call, const DrawPlan& plan, Cause cause, const Quiet& quiet);
  void issue_unrefined(const DrawCall& call, Cause cause) const;
  void pass_planned(const DrawPlan& plan, Cause cause, std::uint64_t triangles);
  void count_class(const DrawPlan& plan, std::optional<Cause> cause, std::uint64_t triangles);
  void draw_refined(const DrawCall& call, const DrawPlan& plan, const Quiet& quiet);
  capture::CoarseTriangles capture(const DrawCall& call, const KeyFacts& facts, KeptDraw& kept, const Quiet& quiet);
  bool draw_repeated(const DrawCall& call, const Quiet& quiet);
  bool draw_kept_vertices(const DrawCall& call, const DrawPlan& plan, const KeptDraw& kept);
  void draw_vertices(const DrawCache::Entry& entry);
  void note_repeated(const DrawCall& call, const DrawPlan& plan, const KeptDraw& kept);
  void refine(const DrawPlan& plan, const capture::CoarseTriangles& captured, const KeptDraw& kept, bool welded);
  void refine_in_parts(const DrawPlan& plan, const ImmediateCapture::Captured& captured, bool welded);
  depth::BinnedInstances sort(const DrawPlan& plan, const Records& records, const KeptDraw& kept);

  const Environment& env_;
  Parts parts_;
  KeptViews views_;
  RepeatedDraws repeated_;
  evaluate::Evaluation evaluation_;
  ImmediateCapture immediate_;
  submit::Submission submission_;
  PassedDraws passed_;
  DrawClasses classes_;
  FrameWatch watch_;
  Watched open_;  // glBegin..glEnd that stays unrefined
};

}  // namespace glark::core
