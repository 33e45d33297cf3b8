// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Captures one draw of the application, and keeps the capture out of the application's errors, modes and queries.
#pragma once

#include <cstdint>
#include <optional>

#include "glark/core/capture/capture.h"
#include "glark/core/capture/capture_plan.h"
#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/draw_call.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/quiet.h"
#include "glark/core/state/environment.h"

namespace glark::capture {

Language language_of(const core::Capabilities& capabilities);

// Returns whether vertices have edge flags that the polygon mode shows.
bool takes_edge_flags(const core::Environment& environment);

// Corrects the application's open queries by the triangles that our own draws have added to them.
void add_surplus(core::GlState& state, std::int64_t triangles);

class DrawCapture {
 public:
  explicit DrawCapture(const core::Environment& environment);

  struct Target {
    Count count = Count::known;
    core::GpuBuffer* own = nullptr;  // null: the ring of the stage
  };
  // Issues the application's call. Nothing if GL rejects the call.
  std::optional<CoarseTriangles> run(const core::DrawCall& call, const CapturePlan& plan, const Target& target,
                                     const core::Quiet& quiet);
  // The two halves of a capture whose draws are issued in between.
  void begin(const CapturePlan& plan, const Target& target);
  CoarseTriangles end(const CapturePlan& plan, std::uint64_t triangles, bool exact);

  // Adds a capture to the statistics. `level` is the level of its uniform draw. Counts that only the GPU knows are
  // added later.
  void count_drawn(const CoarseTriangles& triangles, unsigned level);
  void read_uncounted();

  CaptureStage& stage() { return stage_; }
  const core::GpuBuffer& count_command() const { return stage_.count_command(); }
  void release() { stage_.release(); }

 private:
  void stop_query(Count count);
  void resume_query();

  const core::Environment& env_;
  CaptureStage stage_;
  GLuint stopped_query_ = 0;  // the application's, while its target counts our capture
  bool uncounted_ = false;    // a query holds the number of triangles of the last draw
  unsigned uncounted_level_ = 0;
  unsigned clip_distances_ = 0;  // of the application, which are off until end()
};

}  // namespace glark::capture
