// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws refined triangles: sets up the vertex arrays of lattice, patch and coarse record, and issues the draws. The
// caller binds the program.
#pragma once

#include <cstdint>
#include <map>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/record.h"
#include "glark/core/depth/binned_instances.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/pattern/gpu_pool.h"
#include "glark/core/refine/attribute_locations.h"

namespace glark::submit {

struct UniformDraw {
  capture::CoarseTriangles triangles;
  const capture::Layout* layout = nullptr;
  bool stored = false;  // the program reads the records by itself
  unsigned level = 0;
  bool placed = false;                             // the program takes a patch; required above level deepest_uniform
  const core::GpuBuffer* count_command = nullptr;  // for a count on the GPU
};

class SubmitStage {
 public:
  explicit SubmitStage(const gl::Dispatch& gl) : gl_(gl) {}

  // Draws every coarse triangle at the same level, with one instanced draw for each tile of the level. Binds a vertex
  // array of ours. With a count on the GPU, also binds GL_DRAW_INDIRECT_BUFFER.
  void draw_uniform(const pattern::GpuPool& pool, const UniformDraw& draw);
  // Draws the vertices of a uniform level as points: all of the first coarse triangle, then all of the next one.
  // `first`, `count`: the vertices of the level in the pool.
  void draw_points(const pattern::GpuPool& pool, const capture::CoarseTriangles& triangles,
                   const capture::Layout& layout, GLint first, GLsizei count);
  struct BinnedInputs {
    int chunks = 0;      // chunks of a record that are attributes of the program
    GLuint numbers = 0;  // a buffer of 0, 1, 2, ..., if the program takes the number of the instance
  };
  // Binds a vertex array of ours and GL_DRAW_INDIRECT_BUFFER.
  void draw_binned(const pattern::GpuPool& pool, const depth::BinnedInstances& bins, BinnedInputs inputs);
  void release();

 private:
  enum class Source { whole, uniform, binned, numbered };
  void bind_vertex_array(int chunks, Source source, GLuint indices);

  const gl::Dispatch& gl_;
  struct Key {
    int chunks;
    Source source;
    auto operator<=>(const Key&) const = default;
  };
  struct VertexArray {
    GLuint name = 0;
    GLuint indices = 0;
  };
  std::map<Key, VertexArray> arrays_;
};

}  // namespace glark::submit
