// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Cuts captured quads along their other diagonal, so that both triangles end with the provoking vertex. Flat outputs
// need it where GL captures a triangle without that vertex.
#pragma once

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/programs/compute_pass.h"
#include "glark/core/polygons/decomposition.h"
#include "glark/gl/dispatch.h"

namespace glark::polygons {

class QuadCut {
 public:
  explicit QuadCut(const gl::Dispatch& gl) : gl_(gl) {}

  bool built() const { return pass_.built(); }
  // Rare path: wrap in an ErrorScope.
  bool build();
  // Changes the records in place, the program, and the storage buffer bindings 0 and 1. `captured_count`: holds the
  // CountCommand of triangles that are counted on the GPU.
  void run(const capture::Layout& layout, const capture::CoarseTriangles& triangles, const Cut& cut,
           GLuint captured_count) const;
  void release() { pass_.release(gl_); }

 private:
  const gl::Dispatch& gl_;
  core::ComputePass pass_;
};

}  // namespace glark::polygons
