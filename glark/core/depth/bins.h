// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// From depth tags to draw commands, on the GPU: edge depths, pattern, instances sorted by piece, one command per piece.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/depth/binned_instances.h"
#include "glark/core/depth/depth_plan.h"
#include "glark/core/depth/kept_instances.h"
#include "glark/core/depth/measure/measured_depths.h"
#include "glark/core/depth/reorder.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/pattern/gpu_pool.h"
#include "glark/core/state/bindings.h"

namespace glark::depth {

struct BinRequest {
  const capture::Layout* layout = nullptr;
  capture::CoarseTriangles triangles;
  unsigned uniform_tag = 0;  // where the layout holds no tags
  unsigned pool_level = 0;   // greatest depth
  pattern::Interior interior = pattern::Interior::minimum;
  bool tags_are_edge_depths = false;  // corners 0, 1, 2 hold the depths of edges 0, 1, 2 in place of tags
  MeasuredDepths measured;            // replace the tags, if there are any
  bool counted = true;                // the triangles count for the budget
};

class BinStage {
 public:
  BinStage(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()), compilation_(compilation), language_(language), reorder_(compilation, language) {}

  // Uploads the piece table. Call it again after the pool was replaced. False without memory.
  bool prepare(const pattern::GpuPool& pool);
  // Compiles the passes, and makes room for the instances of a draw. Returns false if that fails.
  bool reserve(const capture::Layout& layout, std::uint32_t triangles, const DepthPlan& plan);
  bool has_room(const capture::Layout& layout, std::uint32_t triangles, const DepthPlan& plan) const;
  std::uint32_t capacity() const { return capacity_; }  // instances of any draw
  // Dispatches the passes. Changes the program, the vertex array, GL_DRAW_INDIRECT_BUFFER and the storage buffer
  // bindings 0 to 3, which the caller restores.
  BinnedInstances sort(const BinRequest& request, GLuint count_buffer, const core::Bindings& bindings);
  // The size of the result of the last sort(); reads back.
  InstanceExtent extent(const BinnedInstances& sorted) const;
  // Instances that the last sort() made; reads back.
  std::uint32_t instances_of_last() const;
  // Triangles drawn since the last call; reads back.
  std::uint64_t take_refined_triangles();
  // Word 2 counts the refined triangles of the budget until it is reset.
  GLuint work_buffer() const { return work_.name(); }
  void release();

 private:
  // Draws that differ in these have passes of their own.
  struct BinKind {
    pattern::Interior interior = pattern::Interior::minimum;
    bool measured = false;
    auto operator<=>(const BinKind&) const = default;
  };
  struct Passes {
    core::ComputePass count;
    core::ComputePass scatter;
    bool built() const { return count.built() && scatter.built(); }
  };
  bool build(core::ComputePass& pass, std::uint64_t number, const BinKind& kind);
  bool compile(const BinKind& kind);
  void set_uniforms(const core::ComputePass& pass, const BinRequest& request) const;

  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  core::ComputePass scan_;
  std::map<BinKind, Passes> passes_;
  core::GpuBuffer work_;
  core::GpuBuffer instances_;
  std::uint32_t capacity_ = 0;  // instances
  Reorder reorder_;
};

}  // namespace glark::depth
