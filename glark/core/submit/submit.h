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

// Where the instances of a piece have their coarse records and their placements.
struct InstanceSource {
  GLuint records = 0;
  GLintptr records_offset = 0;
  GLsizei record_stride = 0;  // bytes
  GLuint patches = 0;         // 0: the piece covers the triangle
  GLintptr patches_offset = 0;
  bool one_patch = false;  // all instances share the first patch
};

// Vertices of a piece as points: all of the first instance, then all of the next one.
struct PointDraw {
  GLuint indices = 0;  // a buffer of uint16: numbers of vertices in the pool; 0: vertices [first, first + count)
  GLint first = 0;     // index in the buffer, or vertex
  GLsizei count = 0;
  GLsizei instances = 0;
  int chunks = 0;  // of a record
  InstanceSource source;
};

class SubmitStage {
 public:
  explicit SubmitStage(const gl::Dispatch& gl) : gl_(gl) {}

  // Draws every coarse triangle at the same level, with one instanced draw for each tile of the level. Binds a vertex
  // array of ours. With a count on the GPU, also binds GL_DRAW_INDIRECT_BUFFER.
  void draw_uniform(const pattern::GpuPool& pool, const UniformDraw& draw);
  // Binds a vertex array of ours.
  void draw_points(const pattern::GpuPool& pool, const PointDraw& draw);
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
  void enable_inputs(int chunks, Source source);  // of a new vertex array

  const gl::Dispatch& gl_;
  struct Key {
    int chunks;
    Source source;
    auto operator<=>(const Key&) const = default;
  };
  struct VertexArray {
    GLuint name = 0;
    GLuint indices = 0;
    std::uint32_t deletions = 0;  // GpuBuffer::deletions() when `indices` was bound
  };
  std::map<Key, VertexArray> arrays_;
};

}  // namespace glark::submit
