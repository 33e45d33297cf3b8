// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Handles draws of few triangles: depths, instances and commands in one dispatch. Many programs have hundreds of such
// draws. The passes of BinStage would cost more than their triangles. Instances keep the order of the triangles, which
// matters for blending.
#pragma once

#include <array>
#include <map>

#include "glark/core/depth/binned_instances.h"
#include "glark/core/depth/kept_instances.h"
#include "glark/core/depth/measure/measure.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/state/bindings.h"

namespace glark::depth {

struct OrderedRequest {
  MeasureRequest measure;  // layout, triangles and measures; tags in the layout replace the measures
  EdgeEnds ends;
  GLuint work = 0;  // BinStage::work_buffer()
  bool tags_are_edge_depths = false;
};

class OrderedStage {
 public:
  OrderedStage(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()), compilation_(compilation), language_(language) {}

  // Returns whether this stage handles draws of so many triangles, if the number is exact.
  static bool may_take(std::uint32_t triangles, const DepthPlan& plan);
  // Compiles the pass for these measures and so many triangles when first called. Returns false if that fails or must
  // wait, or without memory. Rare path: wrap in an ErrorScope. The draw is one of may_take().
  bool reserve(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures);
  // Returns whether reserve() would change nothing.
  bool has_room(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures) const;
  // Returns whether reserve() has failed.
  bool gave_up(std::uint32_t triangles, const Measures& measures) const;
  // Returns whether this stage handles the draw.
  bool takes(const capture::Layout& layout, const capture::CoarseTriangles& triangles, const DepthPlan& plan) const;
  // Changes the program and the storage buffer bindings 0 to 4, which the caller restores. Valid until the next call.
  BinnedInstances sort(const OrderedRequest& request, const core::Bindings& bindings);
  // The size of the result of sort(); reads back.
  InstanceExtent extent(const BinnedInstances& sorted) const;
  void release();

 private:
  using Passes = std::array<core::ComputePass, 3>;  // by size of the work group
  bool build(const Measures& measures, std::size_t group);
  void bind_buffers(const OrderedRequest& request) const;
  // The smallest pass that is built and takes so many triangles. Null: there is none.
  const core::ComputePass* find(const Measures& measures, std::uint32_t triangles) const;

  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  std::map<Measures, Passes> passes_;
  core::GpuBuffer result_;
  bool no_memory_ = false;  // for the result
};

}  // namespace glark::depth
