// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Calls display lists: a cut list segment by segment, any other list as it is.
#include <vector>

#include "glark/core/track/immediate/count_vertex.h"
#include "glark/core/track/lists/list_names.h"
#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// What a call between glBegin and glEnd adds to the primitive.
struct LooseCalls {
  std::uint64_t vertices = 0;
  std::vector<MaterialChange> materials;
};

void add_loose_calls(Context& c, GLuint name, int depth, LooseCalls& calls) {
  const std::shared_ptr<DisplayList> list = track::find_list(c, name);
  if (list == nullptr || depth >= track::deepest_nesting) {
    return;
  }
  calls.vertices += list->loose_vertices;
  calls.materials.insert(calls.materials.end(), list->loose_materials.begin(), list->loose_materials.end());
  for (const ListSegment& segment : list->segments) {
    if (segment.kind == ListSegment::Kind::call) {
      add_loose_calls(c, segment.list, depth + 1, calls);
    } else if (segment.kind == ListSegment::Kind::call_offset) {
      add_loose_calls(c, track::list_base(c) + segment.list, depth + 1, calls);
    }
  }
}

LooseCalls loose_calls(Context& c, GLuint name, int depth) {
  LooseCalls calls;
  add_loose_calls(c, name, depth, calls);
  return calls;
}

// Before a list is called within a captured primitive. If it gives vertices and sets materials, the latter are not
// followed.
void count_loose_calls(Context& c, const LooseCalls& calls) {
  for (const MaterialChange& change : calls.materials) {
    if (calls.vertices == 0) {
      track::change_material(c, change);
    }
  }
  track::count_called(c, calls.vertices);
}

std::uint64_t triangles_of_segment(Context& c, const ListSegment& segment) {
  if (segment.vertex_lists.empty()) {
    return segment.triangles;
  }
  std::uint64_t vertices = segment.vertices;
  for (const VertexList& inner : segment.vertex_lists) {
    vertices += loose_calls(c, (inner.offset ? track::list_base(c) : 0) + inner.list, 0).vertices;
  }
  return triangles_of(segment.mode, vertices);
}

// The list was executed as a whole. It may have ended a primitive, or begun one.
void follow_primitive(Context& c, const DisplayList* list) {
  ImmediateMode& immediate = c.state().immediate();
  if (list != nullptr && list->ends_primitive && immediate.open()) {
    track::primitive_ended(c);
  }
  if (list != nullptr && list->leaves_open && !immediate.open()) {
    immediate.restart_counts();
    immediate.begin(GL_POINTS);
  }
}

void call_list(Context& c, GLuint name, int depth) {
  if (depth >= track::deepest_nesting) {
    return;  // OpenGL 4.6 compatibility, 21.4.2: deeper calls are ignored
  }
  const std::shared_ptr<DisplayList> list = track::find_list(c, name);
  ImmediateMode& immediate = c.state().immediate();
  if (immediate.capturing()) {
    count_loose_calls(c, loose_calls(c, name, depth));
  }
  if (list == nullptr || !list->refinable || !c.refining() || immediate.open()) {
    if (c.refining() && !immediate.open()) {
      track::hand_back_feedback(c);  // the list may draw
    }
    c.gl().CallList(name);
    track::forget_state(c, list != nullptr && !list->calls_lists ? list.get() : nullptr);
    follow_primitive(c, list.get());
    return;
  }
  GLuint base = 0;
  for (const ListSegment& segment : list->segments) {
    base = segment.kind == ListSegment::Kind::call_offset && !segment.joins ? track::list_base(c) : base;
    track::call_segment(c, segment, base, depth);
  }
}

}  // namespace

namespace track {

std::shared_ptr<DisplayList> find_list(const Context& c, GLuint name) {
  const std::lock_guard lock(c.share().mutex);
  const auto found = c.share().lists.find(name);
  return found != c.share().lists.end() ? found->second : nullptr;
}

GLuint list_base(Context& c) {
  if (!c.state().immediate().open()) {  // between glBegin and glEnd nothing can be asked, and nothing changes it
    c.state().refresh();
  }
  return c.state().bindings().list_base;
}

void call_segment(Context& c, const ListSegment& segment, GLuint base, int depth) {
  switch (segment.kind) {
    case ListSegment::Kind::state: run_state(c, segment); break;
    case ListSegment::Kind::draw: run_draw(c, segment, triangles_of_segment(c, segment)); break;
    case ListSegment::Kind::call: call_list(c, segment.list, depth + 1); break;
    case ListSegment::Kind::call_offset: call_list(c, base + segment.list, depth + 1); break;
  }
}

void follow_stacks(Context& c, GLuint base, GLsizei n, GLenum type, const void* lists) {
  for (GLsizei i = 0; i < n && c.share().lists_push; ++i) {
    follow_stack(c, base + name_at(type, lists, i));
  }
}

void forget_state(Context& c, const DisplayList* list) {
  c.state().forget_bindings();
  c.state().fixed_function().touch();
  c.changes().touch_any_matrix();
  c.state().arrays().forget_current_values();
  if (list == nullptr || list->changes_uniforms) {
    c.state().programs().uniforms_changed_unseen();
  }
}

}  // namespace track

namespace hook {

void CallList(Context& c, GLuint name) {
  if (c.state().lists().compiling()) {
    track::record_call(c, name);
    return;
  }
  call_list(c, name, 0);
  track::follow_stack(c, name);
}

void CallLists(Context& c, GLsizei n, GLenum type, const void* lists) {
  if (n < 1 || lists == nullptr || !track::is_name_type(type)) {
    c.gl().CallLists(n, type, lists);
    return;
  }
  if (c.state().lists().compiling()) {
    track::record_calls(c, n, type, lists);
    return;
  }
  const ImmediateMode& immediate = c.state().immediate();
  const GLuint base = track::list_base(c);
  if (!c.refining() || (immediate.open() && !immediate.capturing())) {
    c.gl().CallLists(n, type, lists);
    track::forget_state(c, nullptr);
    for (GLsizei i = 0; i < n; ++i) {
      follow_primitive(c, track::find_list(c, base + track::name_at(type, lists, i)).get());
    }
    track::follow_stacks(c, base, n, type, lists);
    return;
  }
  for (GLsizei i = 0; i < n; ++i) {
    call_list(c, base + track::name_at(type, lists, i), 0);
  }
  track::follow_stacks(c, base, n, type, lists);
}

void DeleteLists(Context& c, GLuint first, GLsizei range) {
  c.gl().DeleteLists(first, range);
  if (range <= 0) {
    return;
  }
  std::vector<std::shared_ptr<DisplayList>> gone;
  {
    const std::lock_guard lock(c.share().mutex);
    std::erase_if(c.share().lists, [&](const auto& entry) {
      const bool inside = entry.first >= first && entry.first - first < static_cast<GLuint>(range);
      if (inside) {
        gone.push_back(entry.second);
      }
      return inside;
    });
  }
  for (const std::shared_ptr<DisplayList>& list : gone) {
    if (list != nullptr) {
      track::delete_segments(c, *list);
    }
  }
}

void ListBase(Context& c, GLuint base) {
  c.gl().ListBase(base);
  if (track::executes(c)) {
    c.state().bindings().list_base = base;
  }
}

GLboolean IsList(Context& c, GLuint name) { return c.gl().IsList(name); }

}  // namespace hook
}  // namespace glark::core
