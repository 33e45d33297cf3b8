// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Measured edge depths: from the length of an edge on the screen, from the normals at its ends, and from the distance
// between its curve and its chord on the screen. All passes run on the GPU: the captured corners run through the
// application's vertex stage, and a compute pass compares the two ends of each edge.
#pragma once

#include <array>
#include <map>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/context_options.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/depth/measure/measured_depths.h"
#include "glark/core/depth/measure/measuring_pass.h"
#include "glark/core/depth/measure/screen_positions.h"
#include "glark/core/depth/measure/shown_edges.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/state/bindings.h"
#include "glark/gl/dispatch.h"

namespace glark::depth {

struct MeasureRequest {
  const capture::Layout* layout = nullptr;
  capture::CoarseTriangles triangles;
  ScreenProgram screen = {};
  int normal_offset = -1;  // of the normal in a captured corner; -1: normals are not measured
  unsigned pool_level = 0;
  Measures measures = {};
  BudgetPlan budget = {};
};

// The uniforms of straight_edge.glsl, in their order there.
inline constexpr std::size_t straight_edge_uniforms = 4;
std::array<GLint, straight_edge_uniforms> straight_edge_words(const MeasureRequest& request);

class MeasureStage {
 public:
  MeasureStage(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()),
        compilation_(compilation),
        language_(language),
        positions_(compilation.gl()),
        shown_(compilation, language) {}

  // Compile the passes when first called; false without memory. Rare path: wrap in an ErrorScope. Small draws need the
  // ends only.
  bool reserve_ends(std::uint32_t triangles, const Measures& measures);
  bool reserve_depths(std::uint32_t triangles, const Measures& measures);
  bool has_ends(std::uint32_t triangles, const Measures& measures) const;
  bool has_depths(std::uint32_t triangles, const Measures& measures) const;
  // Called when a frame has ended. With a budget, the frame's number of triangles decides how coarse the next frame is.
  void frame_finished() { frame_finished_ = true; }
  // `work`: BinStage::work_buffer(). Changes the program, the vertex array and the storage buffer bindings 0 to 3,
  // which the caller restores. The ends are valid until the next call.
  EdgeEnds find_ends(const MeasureRequest& request, const core::EdgeMeasure& rule, GLuint work,
                     const core::Bindings& bindings);
  // The depths, from the result of find_ends().
  MeasuredDepths measure(const MeasureRequest& request, const core::Bindings& bindings);
  void release();

 private:
  void update_limits(const core::EdgeMeasure& rule, bool morphs, GLuint work);

  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  core::ComputePass limits_pass_;
  std::map<Measures, core::ComputePass> depth_passes_;
  core::GpuBuffer limits_;
  ScreenPositions positions_;
  ShownEdges shown_;
  core::EdgeMeasure rule_;     // the limits are made for this rule
  bool limits_tried_ = false;  // to allocate the limits
  bool morphs_ = false;        // and for draws that morph
  bool frame_finished_ = false;
};

}  // namespace glark::depth
