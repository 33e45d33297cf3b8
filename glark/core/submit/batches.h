// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Shallow uniform levels, many coarse triangles an instance. llvmpipe starts its vertex pipeline again for each
// instance, which costs more than the vertices of a small pattern.
#pragma once

#include <array>
#include <cstdint>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/buffer_texels.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/refine/derive.h"
#include "glark/core/state/programs/derived_program.h"
#include "glark/gl/dispatch.h"

namespace glark::submit {

struct BatchDraw {
  const capture::Layout& layout;
  capture::CoarseTriangles triangles;  // counted
  const core::DerivedProgram& program;
  unsigned level = 0;  // at most refine::deepest_batched
};

class Batches {
 public:
  explicit Batches(const gl::Dispatch& gl) : gl_(gl), texels_(gl) {}

  bool built(unsigned level) const { return grids_.at(level).vertex_array != 0; }
  // Rare path: wrap in an ErrorScope.
  void build(unsigned level);
  // Binds a vertex array of ours. The triangles come in their order. The level is built.
  void draw(const BatchDraw& draw);
  void release();

 private:
  struct Grid {
    core::GpuBuffer vertices;
    core::GpuBuffer indices;
    GLuint vertex_array = 0;
    GLsizei index_count = 0;  // of one triangle
  };

  const gl::Dispatch& gl_;
  core::BufferTexels texels_;
  std::array<Grid, refine::deepest_batched + 1> grids_;
};

}  // namespace glark::submit
