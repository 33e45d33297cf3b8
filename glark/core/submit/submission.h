// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The end of a refined draw: binds what it needs, draws, and restores what the application had bound.
#pragma once

#include "glark/core/capture/capture.h"
#include "glark/core/depth/binned_instances.h"
#include "glark/core/keep/refined_vertices.h"
#include "glark/core/pattern/pool_in_use.h"
#include "glark/core/plan/draw_plan.h"
#include "glark/core/plan/feedback_in_use.h"
#include "glark/core/programs/draw_programs.h"
#include "glark/core/state/environment.h"
#include "glark/core/submit/draw_modes.h"
#include "glark/core/submit/submit.h"

namespace glark::submit {

// The triangles of a uniform level, or the instances of an adaptive draw.
struct RefinedTriangles {
  capture::CoarseTriangles triangles;
  const core::GpuBuffer* count_command = nullptr;  // holds the count of triangles that are counted on the GPU
  depth::BinnedInstances instances;
  GLuint numbers = 0;            // a buffer of 0, 1, 2, ..., if the derived program numbers the instances
  bool storage_changed = false;  // storage buffer bindings are not the application's
};

class Submission {
 public:
  struct Parts {
    const pattern::PoolInUse& pool;
    core::DrawPrograms& programs;
    const capture::CaptureStage& capture;
    core::FeedbackInUse& feedback;
  };
  Submission(const core::Environment& environment, const Parts& parts);

  // Switches off modes of the application that would disturb the passes before the draw. `indirect`: the draw or a pass
  // is indirect.
  void begin(const core::DrawPlan& plan, bool indirect) const;
  // Draws, and restores the application's state.
  void draw(const core::DrawPlan& plan, const RefinedTriangles& refined);
  // Draws refined vertices by the application's own program or fixed function.
  void draw_vertices(const core::RefinedVertices& vertices);
  // Call before glDrawTransformFeedback. It draws as many vertices as the last indirect draw, unless GL starts another
  // command buffer in between: fault `captured_after_indirect` of Mesa 22's Vulkan driver, docs/reference/drivers.md.
  void flush_indirect();
  // Restores the vertex array and the program after a capture of no triangles.
  void restore_after_capture() const;
  void release() { stage_.release(); }

 private:
  void set_inputs(const core::DrawPlan& plan, const RefinedTriangles& refined) const;
  void issue(const core::DrawPlan& plan, const RefinedTriangles& refined);
  void stop_restart() const;
  void resume_restart() const;
  void restore_vertex_array() const;
  void restore_storage() const;
  void restore(bool indirect, bool storage) const;

  const core::Environment& env_;
  Parts parts_;
  DrawModes modes_;
  SubmitStage stage_;
  bool drew_indirectly_ = false;  // since the last flush_indirect()
};

}  // namespace glark::submit
