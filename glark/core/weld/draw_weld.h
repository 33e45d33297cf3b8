// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Welds the triangles of one draw: tags after the capture, edges when the triangles to draw are known.
#pragma once

#include "glark/core/state/environment.h"
#include "glark/core/weld/weld.h"

namespace glark::weld {

class DrawWeld {
 public:
  DrawWeld(const core::Environment& environment, capture::Language language)
      : env_(environment), stage_(environment.compilation, language) {}

  WeldStage& stage() { return stage_; }
  const WeldStage& stage() const { return stage_; }
  // Both return whether they have changed the program and the storage buffer bindings, which the caller restores.
  // `captured_count`: holds the CountCommand of triangles that are counted on the GPU.
  bool weld_captured(const WeldPlan& plan, const capture::Layout& layout, const capture::CoarseTriangles& triangles,
                     const core::GpuBuffer& captured_count) {
    return run({.plan = &plan,
                .layout = &layout,
                .triangles = triangles,
                .key_words = {},
                .edges = layout.joins_edges() && !plan.edges_later,
                .tags = layout.tagged,
                .normals = plan.makes_normals},
               captured_count);
  }
  bool weld_split(const WeldPlan& plan, const capture::Layout& layout, const capture::CoarseTriangles& triangles,
                  const core::GpuBuffer& captured_count) {
    return run(
        {.plan = &plan, .layout = &layout, .triangles = triangles, .key_words = {}, .edges = layout.joins_edges()},
        captured_count);
  }
  void release() { stage_.release(); }

 private:
  bool run(WeldRequest request, const core::GpuBuffer& captured_count);

  const core::Environment& env_;
  WeldStage stage_;
};

}  // namespace glark::weld
