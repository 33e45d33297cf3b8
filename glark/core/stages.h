// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The stages of one context that can refine. refined_draw.cpp runs them.
#pragma once

#include <cstdint>
#include <vector>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/feedback/refined_feedback.h"
#include "glark/core/keep/kept_draws.h"
#include "glark/core/meshes/mesh_watch.h"
#include "glark/core/passes/triangle_passes.h"
#include "glark/core/pattern/pool_in_use.h"
#include "glark/core/plan/planner.h"
#include "glark/core/programs/draw_programs.h"
#include "glark/core/refined_draw.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class Stages {
 public:
  explicit Stages(const Environment& environment);
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  RefinedDraw& draw() { return draw_; }
  RefinedFeedback& feedback() { return feedback_; }
  const RefinedFeedback& feedback() const { return feedback_; }
  DrawPrograms& programs() { return programs_; }
  Planner& planner() { return planner_; }
  pattern::PoolInUse& pool() { return pool_; }

  std::int64_t kept_bytes() const { return kept_.bytes(); }  // on the GPU, of draws that repeat

  void frame_finished();
  // The application reads pixels. In a program that neither swaps buffers nor waits for GL, that ends a frame.
  void pixels_read();
  // Deletes all GL objects; only while the context is current.
  void release();
  // Returns the names of the buffers that hold kept draws; the caller has them deleted. Nothing is kept any more.
  std::vector<GLuint> take_kept_buffers() { return kept_.take_buffers(); }

 private:
  void read_counts();

  const Environment env_;
  pattern::PoolInUse pool_;
  capture::DrawCapture capture_;
  DrawPrograms programs_;
  TrianglePasses passes_;
  KeptDraws kept_;
  FeedbackInUse feedback_in_use_;
  MeshWatch meshes_;
  Planner planner_;
  RefinedFeedback feedback_;
  RefinedDraw draw_;
  bool ends_frames_ = false;  // frame_finished() was called
};

}  // namespace glark::core
