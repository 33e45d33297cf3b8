// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Which edges belong to a triangle that can be seen (hidden_triangle.glsl). The others need no depth. Also the depth that
// the insides of these triangles need.
#pragma once

#include <cstdint>
#include <map>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/depth/measure/measuring_pass.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/state/bindings.h"

namespace glark::depth {

// 1: GL culls triangles that go clockwise on the screen; -1: counter-clockwise; 0: neither, or both.
int culled_side(const core::Bindings& bindings);

struct ShownRequest {
  const capture::Layout& layout;
  capture::CoarseTriangles triangles;
  Measures measures;
  unsigned pool_level = 0;
};

class ShownEdges {
 public:
  ShownEdges(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()), compilation_(compilation), language_(language) {}

  bool has_room(std::uint32_t triangles, const Measures& measures) const;
  // Compiles the pass when first called; false without memory. Rare path: wrap in an ErrorScope.
  bool reserve(std::uint32_t triangles, const Measures& measures);
  // Binds the marks to storage binding 3, where the depth pass reads them. The caller has bound the records and the
  // positions to 0 and 1, and the limits to 2. Returns the stamp of this draw. Does nothing if the layout does not tell
  // the sides of an edge.
  GLint mark(const ShownRequest& request, const core::Bindings& bindings);
  void release();

 private:
  void clear(const core::ComputePass& pass);

  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  std::map<Measures, core::ComputePass> passes_;
  core::GpuBuffer marks_;  // a word for each corner
  GLint stamp_ = 0;        // of the last draw; older marks count as cleared
};

}  // namespace glark::depth
