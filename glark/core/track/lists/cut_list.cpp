// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Compiling a display list: it is cut into segments of state changes and segments of one draw each (display_list.h). A
// list that is compiled before refinement is on is not cut.
#include <bit>
#include <functional>
#include <utility>
#include <vector>

#include "glark/core/objects/error_scope.h"
#include "glark/core/track/lists/list_names.h"
#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Mesa 22 joins the strips of a list across restarts, by triangles without area: up to four vertices for each restart.
constexpr std::uint64_t joined = 5;

// A name far from those of applications that number their lists themselves.
GLuint new_segment_name(Context& c) {
  const std::lock_guard lock(c.share().mutex);
  while (c.gl().IsList(c.share().next_list_name) != GL_FALSE) {
    --c.share().next_list_name;
  }
  return c.share().next_list_name--;
}

void open_segment(Context& c, GLenum mode) {
  const GLuint name = new_segment_name(c);
  c.state().lists().open_segment(name);
  c.gl().NewList(name, mode);
}

void close_segment(Context& c, ListSegment segment) {
  ListCompilation& lists = c.state().lists();
  c.gl().EndList();
  const ListSegment& closed = lists.close_segment(std::move(segment), c.state().stamps().next());
  if (closed.kind == ListSegment::Kind::state && lists.executes_too()) {
    track::apply_effects(c, closed.effects);
  }
}

// GL_COMPILE_AND_EXECUTE: executes the segment that was just recorded.
void execute_last(Context& c, GLuint base = 0) {
  ListCompilation& lists = c.state().lists();
  if (!lists.executes_too()) {
    return;
  }
  lists.set_compiling(false);       // the stages draw now
  track::forget_state(c, nullptr);  // GL has executed earlier recorded calls, which glark did not see
  const ListSegment last(lists.last_segment());
  track::call_segment(c, last, base, 0);
  if (last.kind == ListSegment::Kind::call) track::follow_stack(c, last.list);
  if (last.kind == ListSegment::Kind::call_offset) track::follow_stack(c, base + last.list);
  lists.set_compiling(true);
}

// Returns the error that GL raises at once.
GLenum issue(Context& c, const DrawCall& call) {
  ErrorScope errors(c.pending_error());
  call.issue();
  return errors.take();
}

// Any generic attribute may be the one of the tags, and glArrayElement may read it from its array.
bool may_set_tags(const SegmentEffects& effects) {
  constexpr std::uint64_t generic = (std::uint64_t{1} << generic_slots) - 1;
  return effects.opaque || (effects.set & generic) != 0;
}

// The draw of the glBegin..glEnd that has just ended.
ListSegment immediate_segment(Context& c) {
  const ListCompilation& lists = c.state().lists();
  const ImmediateMode& immediate = c.state().immediate();
  // A vertex that adds attributes or components also splits the primitive.
  constexpr std::uint64_t vertices_of_parts = 160;
  const bool restarts = immediate.restarted() || c.state().bindings().primitive_restart || immediate.elements_restart();
  const bool certain = !restarts && !immediate.uncertain();
  const bool parts =
      lists.effects().late || !lists.primitive().vertex_lists().empty() || !std::has_single_bit(immediate.components());
  const std::uint64_t own = immediate.all_vertices();
  const std::uint64_t vertices = (restarts ? joined * own : own) + (parts && own > 0 ? vertices_of_parts : 0);
  return {
      .kind = ListSegment::Kind::draw,
      .mode = lists.primitive().mode(),
      .vertices = vertices,
      .triangles = triangles_of(lists.primitive().mode(), vertices),
      .exact = certain && !parts,
      .sets_tags = immediate.tags_set() || may_set_tags(lists.effects()) || !lists.primitive().vertex_lists().empty(),
      .whole_polygons = (certain && !parts) || lists.primitive().mode() != GL_POLYGON,
      .vertex_lists = lists.primitive().vertex_lists()};
}

// Replaces the application's list with one that calls the segments, and returns the previous list of this name.
std::shared_ptr<DisplayList> put_together(Context& c, const std::shared_ptr<DisplayList>& list, GLuint name) {
  c.gl().NewList(name, GL_COMPILE);
  std::vector<GLuint> names;
  for (auto segment = list->segments.begin(); segment != list->segments.end();) {
    if (segment->kind != ListSegment::Kind::call_offset) {
      c.gl().CallList(segment++->list);
      continue;
    }
    names.clear();
    do {
      names.push_back(segment++->list);
    } while (segment != list->segments.end() && segment->joins);
    c.gl().CallLists(static_cast<GLsizei>(names.size()), GL_UNSIGNED_INT, names.data());
  }
  c.gl().EndList();
  std::shared_ptr<DisplayList> other = list;
  const std::lock_guard lock(c.share().mutex);
  std::swap(c.share().lists[name], other);
  return other;
}

void end_list(Context& c) {
  ListCompilation& lists = c.state().lists();
  lists.set_compiling(false);
  if (lists.executes_too()) track::forget_state(c, nullptr);
  lists.add_loose_vertices(c.state().immediate().vertices());
  if (!lists.cutting()) {
    c.gl().EndList();
    const std::lock_guard lock(c.share().mutex);
    c.share().lists[lists.name()] = lists.end();
    return;
  }
  close_segment(c, {});
  const std::shared_ptr<DisplayList> list = lists.end();
  c.update_refining();
  if (const std::shared_ptr<DisplayList> old = put_together(c, list, lists.name()); old != nullptr) {
    track::delete_segments(c, *old);
  }
}

}  // namespace

namespace track {

void record_draw(Context& c, const DrawCall& call) {
  if (c.state().lists().primitive().open() || !is_triangle_mode(call.mode) || call.never_refined) {
    c.changes().forget_in_list();  // it leaves the values of its last vertex
    call.issue();
    return;
  }
  GLint tag_array = 0;  // its tags are compiled with the vertices
  c.gl().GetVertexAttribiv(c.ark().tag_attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &tag_array);
  close_segment(c, {});
  open_segment(c, GL_COMPILE);
  if (const GLenum error = issue(c, call); error != GL_NO_ERROR) {  // GL does not compile this command
    c.pending_error().raise(error);
    close_segment(c, {});
    open_segment(c, c.state().lists().mode());
    return;
  }
  close_segment(c, {.kind = ListSegment::Kind::draw,
                    .mode = call.mode,
                    .triangles = call.exact ? call.triangles : joined * (call.triangles + 2),
                    .exact = call.exact,
                    .sets_tags = call.tags_vary || tag_array != 0,
                    .whole_polygons = call.whole_polygons,
                    .polygon_sides = call.polygon_sides != nullptr ? *call.polygon_sides : PolygonSides()});
  execute_last(c);
  open_segment(c, c.state().lists().mode());
}

bool list_begin(Context& c, GLenum mode) {
  ListCompilation& lists = c.state().lists();
  if (!lists.cutting() || lists.primitive().open()) {
    return false;
  }
  c.state().immediate().forget_tags();
  c.state().refresh();
  lists.primitive().begin(mode, is_triangle_mode(mode));
  if (is_triangle_mode(mode)) {
    close_segment(c, {});
    open_segment(c, GL_COMPILE);
  } else {
    lists.effects().draws_others = true;
  }
  c.gl().Begin(mode);
  return true;
}

bool list_end(Context& c) {
  ListCompilation& lists = c.state().lists();
  if (!lists.cutting() || !lists.primitive().open()) {
    return false;
  }
  c.gl().End();
  track::record_materials_end(c);
  if (lists.primitive().end()) {
    c.state().refresh();  // restart may have been enabled after glBegin
    close_segment(c, immediate_segment(c));
    execute_last(c);
    open_segment(c, lists.mode());
  }
  return true;
}

void record_call(Context& c, GLuint name) {
  ListCompilation& lists = c.state().lists();
  lists.add_stack_step({StackStep::Kind::call, name});
  if (!lists.cutting() || lists.primitive().open()) {
    lists.add_vertex_list({name, false});
    c.gl().CallList(name);
    if (lists.executes_too()) follow_stack(c, name);
    return;
  }
  close_segment(c, {});
  lists.add_call(ListSegment::Kind::call, name);
  execute_last(c);
  open_segment(c, lists.mode());
}

// The lists that glCallLists calls depend on GL_LIST_BASE at the time when this list is called.
void record_calls(Context& c, GLsizei n, GLenum type, const void* names) {
  ListCompilation& lists = c.state().lists();
  const GLuint base = lists.executes_too() ? list_base(c) : 0;
  for (GLsizei i = 0; i < n; ++i) {
    lists.add_stack_step({StackStep::Kind::call_offset, name_at(type, names, i)});
  }
  if (!lists.cutting() || lists.primitive().open()) {
    for (GLsizei i = 0; i < n; ++i) {
      lists.add_vertex_list({name_at(type, names, i), true});
    }
    c.gl().CallLists(n, type, names);
    if (lists.executes_too()) follow_stacks(c, base, n, type, names);
    return;
  }
  close_segment(c, {});
  for (GLsizei i = 0; i < n; ++i) {
    lists.add_call(ListSegment::Kind::call_offset, name_at(type, names, i), i > 0);
    execute_last(c, base);
  }
  open_segment(c, lists.mode());
}

void outside_list(Context& c, const std::function<void()>& call) {
  ListCompilation& lists = c.state().lists();
  if (!lists.compiling() || !lists.cutting()) {
    call();
    return;
  }
  close_segment(c, {});
  lists.set_compiling(false);
  call();
  lists.set_compiling(true);
  open_segment(c, lists.mode());
}

void delete_segments(Context& c, const DisplayList& list) {
  for (const ListSegment& segment : list.segments) {
    if (segment.kind != ListSegment::Kind::call && segment.kind != ListSegment::Kind::call_offset) {
      c.gl().DeleteLists(segment.list, 1);
    }
  }
}

}  // namespace track

namespace hook {

void NewList(Context& c, GLuint name, GLenum mode) {
  ListCompilation& lists = c.state().lists();
  const bool valid = name != 0 && (mode == GL_COMPILE || mode == GL_COMPILE_AND_EXECUTE) && !lists.compiling() &&
                     !c.state().immediate().open();
  if (!valid) {
    c.gl().NewList(name, mode);  // raises the error
    return;
  }
  if (c.stages() != nullptr) {
    c.state().refresh();  // while the list is compiled, this would count as a change of state
  }
  lists.begin(name, mode, c.stages() != nullptr && (c.options().transparent || c.ark().pool_level >= 0));
  c.state().immediate().restart_counts();
  if (!lists.cutting()) {
    c.gl().NewList(name, mode);
    return;
  }
  open_segment(c, mode);
  c.update_refining();
}

void EndList(Context& c) {
  if (!c.state().lists().compiling()) {
    c.gl().EndList();
    return;
  }
  end_list(c);
}

}  // namespace hook
}  // namespace glark::core
