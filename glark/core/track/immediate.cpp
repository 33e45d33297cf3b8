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
  c.state().immediate().vertices = 0;
  c.state().immediate().components = 0;
  c.state().immediate().limit = UINT64_MAX;
  c.state().immediate().restarted = false;
  c.state().immediate().vertices_before = 0;
  c.state().immediate().triangles_before = 0;
}

void begin_capture(Context& c, GLenum mode) {
  const std::uint64_t room = c.stages()->draw().begin_immediate(mode);
  c.update_refining();
  c.state().immediate().capturing = room > 0;
  const std::uint64_t step = vertices_of_primitive(mode);
  if (room > 0 && step > 0) {
    c.state().immediate().limit = room / triangles_of(mode, step) * step;
  }
}

std::uint64_t triangles_begun(const Context& c, GLenum mode) {
  return c.state().immediate().triangles_before + triangles_of(mode, c.state().immediate().vertices);
}

void end_capture(Context& c) {
  c.stages()->draw().end_immediate(triangles_begun(c, c.state().immediate().mode));
  c.update_refining();
}

}  // namespace

namespace track {

void immediate_full(Context& c) {
  c.gl().End();
  end_capture(c);
  begin_count(c);
  begin_capture(c, c.state().immediate().mode);
  c.gl().Begin(c.state().immediate().mode);
}

}  // namespace track

namespace hook {

void Begin(Context& c, GLenum mode) {
  if (c.state().lists().compiling && !c.state().lists().in_begin) {
    c.state().lists().list->loose_vertices += c.state().immediate().vertices;
  }
  begin_count(c);
  if (c.state().lists().compiling) {
    if (!track::list_begin(c, mode)) {
      c.gl().Begin(mode);
    }
    return;
  }
  const bool nested = c.state().immediate().open;
  c.state().immediate().open = true;
  if (!nested) {
    c.state().immediate().mode = mode;
    c.state().immediate().tags_set = false;
    c.state().immediate().capturing = false;
    if (c.refining()) {
      begin_capture(c, mode);
    }
  }
  c.gl().Begin(mode);
}

void End(Context& c) {
  if (c.state().lists().compiling) {
    if (!track::list_end(c)) {
      c.gl().End();
    }
    begin_count(c);
    return;
  }
  c.gl().End();
  c.state().immediate().open = false;
  if (c.state().immediate().capturing) {
    c.state().immediate().capturing = false;
    c.state().immediate().limit = UINT64_MAX;
    end_capture(c);
  }
}

// Ends the primitive of the open glBegin and begins one of the same mode.
void PrimitiveRestartNV(Context& c) {
  c.gl().PrimitiveRestartNV();
  if (!c.state().immediate().open && !c.state().lists().in_begin) {
    return;
  }
  const GLenum mode = c.state().lists().compiling ? c.state().lists().begun_mode : c.state().immediate().mode;
  const std::uint64_t step = vertices_of_primitive(mode);
  c.state().immediate().restarted = true;
  c.state().immediate().vertices_before += c.state().immediate().vertices;
  c.state().immediate().triangles_before += triangles_of(mode, c.state().immediate().vertices);
  if (c.state().immediate().limit != UINT64_MAX) {
    c.state().immediate().limit -= c.state().immediate().vertices / step * step;
  }
  c.state().immediate().vertices = 0;
}

// From now on glArrayElement may restart, also where that is enabled after glBegin only.
void PrimitiveRestartIndexNV(Context& c, GLuint index) {
  c.gl().PrimitiveRestartIndexNV(index);
  c.state().immediate().elements_restart = true;
}

}  // namespace hook
}  // namespace glark::core
