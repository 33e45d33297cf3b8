// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of glBegin and glEnd. The vertices go straight to GL; they are only counted.
#include "glark/core/plan/programs/program_choice.h"
#include "glark/core/track/immediate/count_vertex.h"
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

// GL refuses other modes of glBegin, and is then not between glBegin and glEnd.
bool is_mode_of_begin(GLenum mode) {
  return mode <= GL_POLYGON || (mode >= GL_LINES_ADJACENCY && mode <= GL_TRIANGLE_STRIP_ADJACENCY);
}

// The parameters of the material that differ between the vertices of some primitives.
MaterialSet varying_materials(Context& c) {
  const MaterialSet noted = c.state().immediate().materials().may_vary();
  if (noted == 0) {
    return 0;
  }
  c.state().refresh();
  return track::replaces_fixed_function(c) && c.gl().IsEnabled(GL_LIGHTING) != GL_FALSE ? noted : 0;
}

// With room for at least `least` vertices.
void begin_capture(Context& c, GLenum mode, std::uint64_t least = 0) {
  const MaterialSet materials = varying_materials(c);
  const std::uint64_t room = c.stages()->draw().begin_immediate(mode, materials, triangles_of(mode, least));
  c.update_refining();
  const std::uint64_t step = vertices_of_primitive(mode);
  const std::uint64_t fitting = step > 0 ? room / triangles_of(mode, step) * step : UINT64_MAX;
  c.state().immediate().capture(room > 0 ? fitting : 0);
  if (room > 0) {
    track::begin_materials(c, materials);
  }
}

std::uint64_t counted_triangles(const ImmediateMode& immediate) {
  return immediate.triangles_before() + triangles_of(immediate.mode(), immediate.vertices());
}

void end_capture(Context& c) {
  c.stages()->draw().end_immediate(counted_triangles(c.state().immediate()));
  track::end_materials(c);
  c.update_refining();
}

// No primitive has vertices so far that it waits to be completed.
bool between_primitives(const ImmediateMode& immediate) {
  const std::uint64_t step = vertices_of_primitive(immediate.mode());
  return immediate.vertices() == 0 || (step > 0 && immediate.vertices() % step == 0 && !immediate.restarted());
}

// The vertices do not carry the parameter: those so far are drawn before it changes. Those that follow carry it.
void restart_capture(Context& c, const MaterialChange& change) {
  ImmediateMode& immediate = c.state().immediate();
  c.gl().End();
  end_capture(c);
  change.call(c.gl(), change);
  immediate.materials().expect(change.parameters());
  immediate.restart_counts();
  begin_capture(c, immediate.mode());
  c.gl().Begin(immediate.mode());
}

}  // namespace

namespace track {

namespace {

bool elements_give_vertices(Context& c) {
  c.state().refresh();
  ArrayState& arrays = c.state().arrays();
  return arrays.attribute_source(vertex_slot).enabled || arrays.attribute_source(generic_slot(0)).enabled;
}

}  // namespace

VertexSources vertex_sources(Context& c) {
  VertexSources sources{.elements = elements_give_vertices(c)};
  if (c.share().maps_vertices) {
    const auto enabled = [&c](GLenum map) { return c.gl().IsEnabled(map) != GL_FALSE; };
    sources.map1 = enabled(GL_MAP1_VERTEX_3) || enabled(GL_MAP1_VERTEX_4);
    sources.map2 = enabled(GL_MAP2_VERTEX_3) || enabled(GL_MAP2_VERTEX_4);
  }
  return sources;
}

bool gives_vertex(Context& c, VertexSource source) {
  const ListCompilation& lists = c.state().lists();
  if (!lists.compiling()) {
    return c.state().immediate().sources().give(source);
  }
  if (source != VertexSource::elements) {  // the maps are those of the time when the list is called
    c.state().immediate().note_uncertain();
    return true;
  }
  const bool may_ask = lists.cutting() || !lists.executes_too();
  return !may_ask || elements_give_vertices(c);
}

void immediate_full(Context& c, std::uint64_t least) {
  ImmediateMode& immediate = c.state().immediate();
  c.gl().End();
  end_capture(c);
  immediate.restart_counts();
  begin_capture(c, immediate.mode(), least);
  c.gl().Begin(immediate.mode());
}

void count_called(Context& c, std::uint64_t vertices) {
  ImmediateMode& immediate = c.state().immediate();
  if (!immediate.fits(vertices) && between_primitives(immediate)) {
    immediate_full(c, vertices);
  }
  immediate.count_called(vertices);
}

void primitive_ended(Context& c) {
  ImmediateMode& immediate = c.state().immediate();
  if (immediate.end()) {
    end_capture(c);
    immediate.materials().primitive_ended();
  } else if (c.refining()) {
    c.stages()->draw().end_unrefined(counted_triangles(immediate));
  }
  for (const MaterialChange& late : immediate.materials().take_deferred()) {
    late.call(c.gl(), late);
  }
}

void change_material(Context& c, const MaterialChange& change) {
  ImmediateMode& immediate = c.state().immediate();
  if (c.state().lists().compiling()) {
    record_material(c, change);
    return;
  }
  if (!immediate.open() || !c.refining()) {
    change.call(c.gl(), change);
    return;
  }
  if (immediate.capturing() && !replaces_fixed_function(c)) {
    immediate.materials().defer(change);
    return;
  }
  const MaterialSet parameters = change.parameters();
  const bool carried = immediate.capturing() && (parameters & ~immediate.materials().carried()) == 0;
  if (!carried && between_primitives(immediate) && immediate.capturing()) {
    restart_capture(c, change);
    return;
  }
  if (!between_primitives(immediate)) {
    immediate.materials().note(parameters);
  }
  change.call(c.gl(), change);
  if (carried) {
    carry_change(c, change, parameters);
  }
}

bool replaces_fixed_function(Context& c) {
  const ProgramChoice choice =
      choose_program(c.state().bindings(), c.state().programs().current().get(),
                     {.is_compatibility = c.capabilities().is_compatibility(), .transparent = c.options().transparent});
  return choice.stage == VertexStage::fixed_function;
}

}  // namespace track

namespace hook {

void Begin(Context& c, GLenum mode) {
  if (!is_mode_of_begin(mode)) {
    c.gl().Begin(mode);
    return;
  }
  ImmediateMode& immediate = c.state().immediate();
  if (c.state().lists().compiling()) {
    c.state().lists().add_loose_vertices(immediate.vertices());
    immediate.restart_counts();
    if (!track::list_begin(c, mode)) {
      c.state().lists().note_begin();
      c.gl().Begin(mode);
    }
    return;
  }
  immediate.restart_counts();
  if (c.refining() && !immediate.open() && c.stages()->feedback().refuses(mode)) {
    c.pending_error().raise(GL_INVALID_OPERATION);
    return;
  }
  if (c.refining() && !immediate.open()) {
    immediate.set_sources(track::vertex_sources(c));
  }
  if (immediate.begin(mode) && c.refining()) {
    begin_capture(c, mode);
  }
  c.gl().Begin(mode);
}

void End(Context& c) {
  ImmediateMode& immediate = c.state().immediate();
  if (c.state().lists().compiling()) {
    if (!track::list_end(c)) {
      c.state().lists().note_end();
      c.gl().End();
    }
    immediate.restart_counts();
    return;
  }
  c.gl().End();
  track::primitive_ended(c);
}

// Ends the primitive of the open glBegin and begins one of the same mode.
void PrimitiveRestartNV(Context& c) {
  c.gl().PrimitiveRestartNV();
  ImmediateMode& immediate = c.state().immediate();
  const ListCompilation& lists = c.state().lists();
  if (!immediate.open() && !lists.primitive().open()) {
    return;
  }
  const GLenum mode = lists.compiling() ? lists.primitive().mode() : immediate.mode();
  immediate.restart(triangles_of(mode, immediate.vertices()), vertices_of_primitive(mode));
}

// From now on glArrayElement may restart, even if restart is enabled only after glBegin.
void PrimitiveRestartIndexNV(Context& c, GLuint index) {
  c.gl().PrimitiveRestartIndexNV(index);
  c.state().immediate().note_elements_restart();
}

}  // namespace hook
}  // namespace glark::core
