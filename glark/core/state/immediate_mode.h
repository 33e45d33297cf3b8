// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What is known between glBegin and glEnd. The vertices go straight to GL; here they are only counted.
#pragma once

#include <cstdint>

#include "glark/gl/types.h"

namespace glark::core {

struct ImmediateMode {
  bool open = false;       // between glBegin and glEnd
  bool capturing = false;  // the refined draw captures its vertices
  GLenum mode = 0;
  bool tags_set = false;               // glDepthTag1i was called
  bool restarted = false;              // by glPrimitiveRestartNV
  bool elements_restart = false;       // glPrimitiveRestartIndexNV was called: glArrayElement may restart
  std::uint64_t vertices_before = 0;   // vertices of the primitives that a restart ended
  std::uint64_t triangles_before = 0;  // triangles of the primitives that a restart ended
  std::uint64_t vertices = 0;          // since glBegin or the last restart
  unsigned components = 0;             // bits: the numbers of components that those vertices have
  std::uint64_t limit = UINT64_MAX;    // this many vertices fit the current capture

  bool full() const { return vertices == limit; }
  void count(unsigned vertex_components) {
    ++vertices;
    components |= 1U << vertex_components;
  }
  bool before_vertices() const { return vertices == 0 && vertices_before == 0; }
};

}  // namespace glark::core
