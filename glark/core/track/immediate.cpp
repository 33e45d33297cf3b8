// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of glBegin and glEnd. The vertices go straight to GL; they are only counted.
#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Vertices of one primitive; 0 for modes whose primitives share vertices.
std::uint64_t vertices_of_primitive(GLenum mode) {
  switch (mode) {
    case GL_TRIANGLES: return 3;
    case GL_QUADS: return 4;
    case GL_TRIANGLES_ADJACENCY: return 6;
    default: return 0;
  }
}

void begin_capture(Context& c, GLenum mode) {
  const std::uint64_t room = c.stages()->draw().begin_immediate(mode);
  c.update_refining();
  const std::uint64_t step = vertices_of_primitive(mode);
  const std::uint64_t fitting = step > 0 ? room / triangles_of(mode, step) * step : UINT64_MAX;
  c.state().immediate().capture(room > 0 ? fitting : 0);
}

void end_capture(Context& c) {
  const ImmediateMode& immediate = c.state().immediate();
  c.stages()->draw().end_immediate(immediate.triangles_before() + triangles_of(immediate.mode(), immediate.vertices()));
  c.update_refining();
}

}  // namespace

namespace track {

void immediate_full(Context& c) {
  ImmediateMode& immediate = c.state().immediate();
  c.gl().End();
  end_capture(c);
  immediate.restart_counts();
  begin_capture(c, immediate.mode());
  c.gl().Begin(immediate.mode());
}

}  // namespace track

namespace hook {

void Begin(Context& c, GLenum mode) {
  ImmediateMode& immediate = c.state().immediate();
  if (c.state().lists().compiling()) {
    c.state().lists().add_loose_vertices(immediate.vertices());
    immediate.restart_counts();
    if (!track::list_begin(c, mode)) {
      c.gl().Begin(mode);
    }
    return;
  }
  immediate.restart_counts();
  if (immediate.begin(mode) && c.refining()) {
    begin_capture(c, mode);
  }
  c.gl().Begin(mode);
}

void End(Context& c) {
  ImmediateMode& immediate = c.state().immediate();
  if (c.state().lists().compiling()) {
    if (!track::list_end(c)) {
      c.gl().End();
    }
    immediate.restart_counts();
    return;
  }
  c.gl().End();
  if (immediate.end()) {
    end_capture(c);
  }
}

// Ends the primitive of the open glBegin and begins one of the same mode.
void PrimitiveRestartNV(Context& c) {
  c.gl().PrimitiveRestartNV();
  ImmediateMode& immediate = c.state().immediate();
  const ListCompilation& lists = c.state().lists();
  if (!immediate.open() && !lists.in_primitive()) {
    return;
  }
  const GLenum mode = lists.compiling() ? lists.primitive_mode() : immediate.mode();
  immediate.restart(triangles_of(mode, immediate.vertices()), vertices_of_primitive(mode));
}

// From now on glArrayElement may restart, even if restart is enabled only after glBegin.
void PrimitiveRestartIndexNV(Context& c, GLuint index) {
  c.gl().PrimitiveRestartIndexNV(index);
  c.state().immediate().note_elements_restart();
}

}  // namespace hook
}  // namespace glark::core
