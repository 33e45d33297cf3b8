// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glBegin and glEnd. The vertices themselves go straight to GL; they are only counted.
#include "glark/core/track/track.h"

namespace glark::core::hook {

void Begin(Context& c, GLenum mode) {
  if (c.compiling_list && !c.list.in_begin) {
    c.list.list->loose_vertices += c.immediate_vertices;
  }
  c.immediate_vertices = 0;
  if (c.compiling_list) {
    if (!track::list_begin(c, mode)) {
      c.gl.Begin(mode);
    }
    return;
  }
  const bool nested = c.immediate.open;
  c.immediate.open = true;
  if (!nested) {
    c.immediate.mode = mode;
    c.immediate.tags_set = false;
    c.immediate.capturing = c.refining && c.pipeline->begin_immediate(mode);
  }
  c.gl.Begin(mode);
}

void End(Context& c) {
  if (c.compiling_list) {
    if (!track::list_end(c)) {
      c.gl.End();
    }
    c.immediate_vertices = 0;
    return;
  }
  c.gl.End();
  c.immediate.open = false;
  if (c.immediate.capturing) {
    c.immediate.capturing = false;
    c.pipeline->end_immediate(c.immediate.mode, c.immediate_vertices, c.immediate.tags_set);
  }
}

}  // namespace glark::core::hook
