// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// glBegin and glEnd. The vertices themselves go straight to GL; they are only counted.
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Of a mode whose primitives share no vertices; 0 of the others.
std::uint64_t vertices_of_primitive(GLenum mode) {
  switch (mode) {
    case GL_TRIANGLES: return 3;
    case GL_QUADS: return 4;
    case GL_TRIANGLES_ADJACENCY: return 6;
    default: return 0;
  }
}

void begin_count(Context& c) {
  c.immediate_vertices = 0;
  c.immediate_components = 0;
  c.immediate_limit = UINT64_MAX;
  c.immediate.restarted = false;
  c.immediate.vertices_before = 0;
  c.immediate.triangles_before = 0;
}

void begin_capture(Context& c, GLenum mode) {
  const std::uint64_t room = c.pipeline->begin_immediate(mode);
  c.immediate.capturing = room > 0;
  const std::uint64_t step = vertices_of_primitive(mode);
  if (room > 0 && step > 0) {
    c.immediate_limit = room / triangles_of(mode, step) * step;
  }
}

std::uint64_t triangles_begun(const Context& c, GLenum mode) {
  return c.immediate.triangles_before + triangles_of(mode, c.immediate_vertices);
}

}  // namespace

namespace track {

void immediate_full(Context& c) {
  c.gl.End();
  c.pipeline->end_immediate(triangles_begun(c, c.immediate.mode));
  begin_count(c);
  begin_capture(c, c.immediate.mode);
  c.gl.Begin(c.immediate.mode);
}

}  // namespace track

namespace hook {

void Begin(Context& c, GLenum mode) {
  if (c.compiling_list && !c.list.in_begin) {
    c.list.list->loose_vertices += c.immediate_vertices;
  }
  begin_count(c);
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
    c.immediate.capturing = false;
    if (c.refining) {
      begin_capture(c, mode);
    }
  }
  c.gl.Begin(mode);
}

void End(Context& c) {
  if (c.compiling_list) {
    if (!track::list_end(c)) {
      c.gl.End();
    }
    begin_count(c);
    return;
  }
  c.gl.End();
  c.immediate.open = false;
  if (c.immediate.capturing) {
    c.immediate.capturing = false;
    c.immediate_limit = UINT64_MAX;
    c.pipeline->end_immediate(triangles_begun(c, c.immediate.mode));
  }
}

// Ends the primitive of the open glBegin and begins one of the same mode.
void PrimitiveRestartNV(Context& c) {
  c.gl.PrimitiveRestartNV();
  if (!c.immediate.open && !c.list.in_begin) {
    return;
  }
  const GLenum mode = c.compiling_list ? c.list.begun_mode : c.immediate.mode;
  const std::uint64_t step = vertices_of_primitive(mode);
  c.immediate.restarted = true;
  c.immediate.vertices_before += c.immediate_vertices;
  c.immediate.triangles_before += triangles_of(mode, c.immediate_vertices);
  if (c.immediate_limit != UINT64_MAX) {
    c.immediate_limit -= c.immediate_vertices / step * step;
  }
  c.immediate_vertices = 0;
}

// From now on glArrayElement may restart, also where that is enabled after glBegin only.
void PrimitiveRestartIndexNV(Context& c, GLuint index) {
  c.gl.PrimitiveRestartIndexNV(index);
  c.elements_restart = true;
}

}  // namespace hook
}  // namespace glark::core
