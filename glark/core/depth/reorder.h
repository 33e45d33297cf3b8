// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Puts coarse records into the order of their instances: draws the records through an index buffer and captures them
// again. Vertex fetch moves whole corners; a compute shader would move single words.
// The draw uses triangles. Mesa keeps the mode of a paused transform feedback (the application's) in the context, not
// in the object, so our feedback must use the same mode.
#pragma once

#include <map>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/objects/programs/compilation.h"
#include "glark/core/state/bindings.h"
#include "glark/gl/dispatch.h"

namespace glark::depth {

// The order: three corners per instance (uint32) from the start of `indices`. The DrawElementsIndirectCommand in
// `commands` holds their number.
struct Order {
  GLuint indices = 0;
  GLuint commands = 0;
  GLintptr command_offset = 0;
};

class Reorder {
 public:
  Reorder(core::Compilation& compilation, capture::Language language)
      : gl_(compilation.gl()), compilation_(compilation), language_(language) {}

  // Makes room for `instances` records, and builds the program for their layout. Rare path inside: wrap in an
  // ErrorScope.
  bool reserve(const capture::Layout& layout, std::uint32_t instances);
  bool has_room(const capture::Layout& layout, std::uint32_t instances) const;

  // Binds a program, a vertex array and GL_DRAW_INDIRECT_BUFFER. Restores other bindings from `bindings`.
  void run(const capture::Layout& layout, const capture::CoarseTriangles& triangles, const Order& order,
           const core::Bindings& bindings);

  GLuint records() const { return records_.name(); }
  static GLsizei stride(const capture::Layout& layout) { return layout.triangle_words() * 4; }
  void release();

 private:
  struct Mover {
    bool tried = false;
    GLuint program = 0;
    GLuint vertex_array = 0;
  };
  void build(Mover& mover, int corner_words);

  const gl::Dispatch& gl_;
  core::Compilation& compilation_;
  capture::Language language_;
  std::map<int, Mover> movers_;  // by the number of words in a corner
  core::GpuBuffer records_;
  GLuint feedback_ = 0;
};

}  // namespace glark::depth
