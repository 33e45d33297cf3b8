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
#include "glark/core/objects/compute_pass.h"
#include "glark/core/objects/gpu_buffer.h"
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
  OrderedStage(const gl::Dispatch& gl, capture::Language language) : gl_(gl), language_(language) {}

  // Compiles the passes for these measures when first called. Rare path: wrap in an ErrorScope.
  void reserve(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures);
  // Returns whether reserve() would change nothing.
  bool has_room(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures) const;
  // Returns whether this stage handles the draw. The draw must have a minimum interior.
  bool takes(const capture::Layout& layout, const capture::CoarseTriangles& triangles, const DepthPlan& plan) const;
  // Changes the program and the storage buffer bindings 0 to 4, which the caller restores. Valid until the next call.
  BinnedInstances sort(const OrderedRequest& request, const core::Bindings& bindings);
  // The size of the result of sort(); reads back.
  InstanceExtent extent(const BinnedInstances& sorted) const;
  void release();

 private:
  // The passes by size of the work group; built together.
  struct Passes {
    std::array<core::ComputePass, 3> by_size;

    bool built() const { return by_size[0].built(); }
    void release(const gl::Dispatch& gl);
  };
  Passes& prepare(const Measures& measures);
  void bind_buffers(const OrderedRequest& request) const;
  const Passes* find(const Measures& measures) const;  // null: not prepared

  const gl::Dispatch& gl_;
  capture::Language language_;
  std::map<Measures, Passes> passes_;
  core::GpuBuffer result_;
};

}  // namespace glark::depth
