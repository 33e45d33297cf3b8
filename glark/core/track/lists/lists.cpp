// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists, cut into segments while they are compiled (see display_list.h). Lists that were compiled before refinement
// was on are called as they are.
#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

// Mesa 22 joins strips of a list, which a restart parted, by triangles of no area: up to four vertices for each restart.
constexpr std::uint64_t joined = 5;

// Out of the way of applications that number their lists themselves; and not one that glGenLists gave out meanwhile (Mesa
// goes on from the highest name in use).
GLuint new_segment_name(Context& c) {
  const std::lock_guard lock(c.share().mutex);
  while (c.gl().IsList(c.share().next_list_name) != GL_FALSE) {
    ++c.share().next_list_name;
  }
  return c.share().next_list_name++;
}

void open_segment(Context& c, GLenum mode) {
  c.state().lists().open_segment = new_segment_name(c);
  c.gl().NewList(c.state().lists().open_segment, mode);
}

void close_segment(Context& c, ListSegment segment) {
  c.gl().EndList();
  segment.list = c.state().lists().open_segment;
  segment.identity = c.state().next_stamp();
  segment.effects = std::exchange(c.state().lists().segment, {});
  segment.effects.changes_uniforms = std::exchange(c.state().lists().changes_uniforms, false);
  c.state().lists().list->changes_uniforms |= segment.effects.changes_uniforms;
  if (segment.kind == ListSegment::Kind::state && c.state().lists().mode == GL_COMPILE_AND_EXECUTE) {
    track::apply_effects(c, segment.effects);
  }
  c.state().lists().list->segments.push_back(std::move(segment));
}

void delete_segments(Context& c, const DisplayList& list) {
  for (const ListSegment& segment : list.segments) {
    if (segment.kind != ListSegment::Kind::call && segment.kind != ListSegment::Kind::call_offset) {
      c.gl().DeleteLists(segment.list, 1);
    }
  }
}

// State that a list may have changed without our seeing it.
void forget_state(Context& c, const DisplayList* list) {
  c.state().forget_bindings();
  c.state().forget_fixed_function();
  c.state().touch_any_matrix();
  c.state().forget_current_values();
  if (list == nullptr || list->changes_uniforms) {
    track::forget_uniforms(c);
  }
}

void run_segment(Context& c, const ListSegment& segment, int depth);

// What a call between glBegin and glEnd adds to the primitive.
std::uint64_t vertices_of(Context& c, GLuint name, int depth) {
  const std::shared_ptr<DisplayList> list = track::find_list(c, name);
  if (list == nullptr || depth >= track::deepest_nesting) {
    return 0;
  }
  std::uint64_t count = list->loose_vertices;
  for (const ListSegment& segment : list->segments) {
    if (segment.kind == ListSegment::Kind::call) {
      count += vertices_of(c, segment.list, depth + 1);
    } else if (segment.kind == ListSegment::Kind::call_offset) {
      count += vertices_of(c, track::list_base(c) + segment.list, depth + 1);
    }
  }
  return count;
}

std::uint64_t triangles_of_segment(Context& c, const ListSegment& segment) {
  if (segment.vertex_lists.empty()) {
    return segment.triangles;
  }
  std::uint64_t vertices = segment.vertices;
  for (const VertexList& inner : segment.vertex_lists) {
    vertices += vertices_of(c, (inner.offset ? track::list_base(c) : 0) + inner.list, 0);
  }
  return triangles_of(segment.mode, vertices);
}

void call_list(Context& c, GLuint name, int depth) {
  if (depth >= track::deepest_nesting) {
    return;  // OpenGL 4.6 compatibility, 21.4.2: deeper calls are ignored
  }
  const std::shared_ptr<DisplayList> list = track::find_list(c, name);
  if (c.state().immediate().capturing) {
    c.state().immediate().vertices += vertices_of(c, name, depth);
  }
  if (list == nullptr || !list->refinable || !c.refining() || c.state().immediate().open) {
    if (c.refining() && !c.state().immediate().open) {
      track::hand_back_feedback(c);  // it may draw
    }
    c.gl().CallList(name);
    forget_state(c, list != nullptr && !list->calls_lists ? list.get() : nullptr);
    return;
  }
  for (const ListSegment& segment : list->segments) {
    run_segment(c, segment, depth);
  }
}

void run_segment(Context& c, const ListSegment& segment, int depth) {
  switch (segment.kind) {
    case ListSegment::Kind::state: track::run_state(c, segment); break;
    case ListSegment::Kind::draw: track::run_draw(c, segment, triangles_of_segment(c, segment)); break;
    case ListSegment::Kind::call: call_list(c, segment.list, depth + 1); break;
    case ListSegment::Kind::call_offset: call_list(c, track::list_base(c) + segment.list, depth + 1); break;
  }
}

// Whether the segment just recorded must also be executed.
void execute_last(Context& c) {
  if (c.state().lists().mode == GL_COMPILE_AND_EXECUTE) {
    c.state().lists().compiling = false;  // the stages draw now
    forget_state(c, nullptr);             // what was recorded before it was executed too, unseen
    const ListSegment last(c.state().lists().list->segments.back());
    run_segment(c, last, 0);
    if (last.kind == ListSegment::Kind::call) track::follow_stack(c, last.list);
    if (last.kind == ListSegment::Kind::call_offset) track::follow_stack(c, track::list_base(c) + last.list);
    c.state().lists().compiling = true;
  }
}

template <typename Name>
GLuint integer_at(const void* lists, GLsizei i) {
  return static_cast<GLuint>(static_cast<GLint>(static_cast<const Name*>(lists)[i]));
}

// OpenGL 4.6 compatibility, 21.4: GL_2_BYTES and the like are big-endian groups of bytes.
bool decode_name(GLenum type, const void* lists, GLsizei i, GLuint& name) {
  const auto* bytes = static_cast<const GLubyte*>(lists);
  const auto group = [&](GLsizei size) {
    GLuint value = 0;
    for (GLsizei k = 0; k < size; ++k) {
      value = value << 8 | bytes[i * size + k];
    }
    return value;
  };
  switch (type) {
    case GL_BYTE: name = integer_at<GLbyte>(lists, i); return true;
    case GL_UNSIGNED_BYTE: name = bytes[i]; return true;
    case GL_SHORT: name = integer_at<GLshort>(lists, i); return true;
    case GL_UNSIGNED_SHORT: name = static_cast<const GLushort*>(lists)[i]; return true;
    case GL_INT: name = integer_at<GLint>(lists, i); return true;
    case GL_UNSIGNED_INT: name = static_cast<const GLuint*>(lists)[i]; return true;
    case GL_FLOAT: name = static_cast<GLuint>(static_cast<GLint>(static_cast<const GLfloat*>(lists)[i])); return true;
    case GL_2_BYTES: name = group(2); return true;
    case GL_3_BYTES: name = group(3); return true;
    case GL_4_BYTES: name = group(4); return true;
    default: return false;
  }
}

GLuint name_at(GLenum type, const void* lists, GLsizei i) {
  GLuint name = 0;
  decode_name(type, lists, i, name);
  return name;
}

void follow_stacks(Context& c, GLsizei n, GLenum type, const void* lists) {
  for (GLsizei i = 0; i < n && c.share().lists_push; ++i)
    track::follow_stack(c, track::list_base(c) + name_at(type, lists, i));
}

// glCallLists while a list is compiled: what it calls depends on GL_LIST_BASE at the time of the call.
void record_calls(Context& c, GLsizei n, GLenum type, const void* lists) {
  c.state().lists().list->calls_lists = true;
  for (GLsizei i = 0; i < n && !c.state().lists().in_begin; ++i)
    c.state().lists().list->stack_steps.push_back({StackStep::Kind::call_offset, name_at(type, lists, i)});
  if (!c.state().lists().cutting || c.state().lists().in_begin) {
    for (GLsizei i = 0; i < n; ++i) {
      c.state().lists().vertex_lists.push_back({name_at(type, lists, i), true});
    }
    c.gl().CallLists(n, type, lists);
    if (c.state().lists().mode == GL_COMPILE_AND_EXECUTE) follow_stacks(c, n, type, lists);
    return;
  }
  close_segment(c, {});
  for (GLsizei i = 0; i < n; ++i) {
    c.state().lists().list->segments.push_back(
        {.kind = ListSegment::Kind::call_offset, .list = name_at(type, lists, i)});
    execute_last(c);
  }
  open_segment(c, c.state().lists().mode);
}

void end_list(Context& c) {
  c.state().lists().compiling = false;
  if (c.state().lists().mode == GL_COMPILE_AND_EXECUTE) forget_state(c, nullptr);
  c.state().lists().list->loose_vertices += c.state().lists().in_begin ? 0 : c.state().immediate().vertices;
  if (!c.state().lists().cutting) {
    c.state().lists().list->changes_uniforms = c.state().lists().changes_uniforms;
    c.gl().EndList();
    const std::lock_guard lock(c.share().mutex);
    c.share().lists[c.state().lists().name] = std::move(c.state().lists().list);
    return;
  }
  close_segment(c, {});
  const std::shared_ptr<DisplayList> list = c.state().lists().list;
  list->refinable = !c.state().lists().in_begin;  // a glBegin left open reaches into the next list
  c.state().lists().cutting = false;
  c.update_refining();
  c.gl().NewList(c.state().lists().name, GL_COMPILE);
  for (const ListSegment& segment : list->segments) {
    if (segment.kind == ListSegment::Kind::call_offset) {
      c.gl().CallLists(1, GL_UNSIGNED_INT, &segment.list);
    } else {
      c.gl().CallList(segment.list);
    }
  }
  c.gl().EndList();
  std::shared_ptr<DisplayList> old = list;
  {
    const std::lock_guard lock(c.share().mutex);
    std::swap(c.share().lists[c.state().lists().name], old);
  }
  if (old != nullptr) {
    delete_segments(c, *old);
  }
  c.state().lists().list = nullptr;
}

}  // namespace

namespace track {

std::shared_ptr<DisplayList> find_list(Context& c, GLuint name) {
  const std::lock_guard lock(c.share().mutex);
  const auto found = c.share().lists.find(name);
  return found != c.share().lists.end() ? found->second : nullptr;
}

GLuint list_base(Context& c) {
  if (!c.state().immediate().open) {  // between glBegin and glEnd nothing can be asked, and nothing changes it
    c.state().refresh();
  }
  return c.state().bindings().list_base;
}

void record_draw(Context& c, const DrawCall& call) {
  if (c.state().lists().in_begin || !is_triangle_mode(call.mode)) {
    call.issue();
    return;
  }
  GLint tag_array = 0;  // its tags are compiled with the vertices
  c.gl().GetVertexAttribiv(c.ark().tag_attribute, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &tag_array);
  close_segment(c, {});
  open_segment(c, GL_COMPILE);
  call.issue();
  close_segment(c, {.kind = ListSegment::Kind::draw,
                    .mode = call.mode,
                    .triangles = call.exact ? call.triangles : joined * (call.triangles + 2),
                    .exact = call.exact,
                    .sets_tags = call.tags_vary || tag_array != 0,
                    .whole_polygons = call.whole_polygons,
                    .polygon_sides = call.polygon_sides != nullptr ? *call.polygon_sides : PolygonSides()});
  execute_last(c);
  open_segment(c, c.state().lists().mode);
}

bool list_begin(Context& c, GLenum mode) {
  if (!c.state().lists().cutting || c.state().lists().in_begin) {
    return false;
  }
  c.state().lists().in_begin = true;
  c.state().immediate().tags_set = false;
  c.state().lists().begun_mode = mode;
  c.state().refresh();
  c.state().lists().vertex_lists.clear();
  c.state().lists().in_draw = is_triangle_mode(mode);
  if (c.state().lists().in_draw) {
    close_segment(c, {});
    open_segment(c, GL_COMPILE);
  }
  c.gl().Begin(mode);
  return true;
}

bool list_end(Context& c) {
  if (!c.state().lists().cutting || !c.state().lists().in_begin) {
    return false;
  }
  c.gl().End();
  c.state().lists().in_begin = false;
  if (!c.state().lists().in_draw) {
    return true;
  }
  c.state().lists().in_draw = false;
  c.state().refresh();  // restart may have been enabled after glBegin
  // A vertex that has more to it than those before parts the primitive, too.
  constexpr std::uint64_t vertices_of_parts = 160;
  const bool restarts = c.state().immediate().restarted || c.state().bindings().primitive_restart ||
                        c.state().immediate().elements_restart;
  const bool parts = c.state().lists().segment.late || !c.state().lists().vertex_lists.empty() ||
                     !std::has_single_bit(c.state().immediate().components);
  const std::uint64_t own = c.state().immediate().vertices_before + c.state().immediate().vertices;
  const std::uint64_t vertices = (restarts ? joined * own : own) + (parts && own > 0 ? vertices_of_parts : 0);
  close_segment(c, {.kind = ListSegment::Kind::draw,
                    .mode = c.state().lists().begun_mode,
                    .vertices = vertices,
                    .triangles = triangles_of(c.state().lists().begun_mode, vertices),
                    .exact = !restarts && !parts,
                    .sets_tags = c.state().immediate().tags_set || !c.state().lists().vertex_lists.empty(),
                    .whole_polygons = !restarts && !parts,
                    .vertex_lists = std::move(c.state().lists().vertex_lists)});
  execute_last(c);
  open_segment(c, c.state().lists().mode);
  return true;
}

}  // namespace track

namespace hook {

void NewList(Context& c, GLuint name, GLenum mode) {
  const bool valid = name != 0 && (mode == GL_COMPILE || mode == GL_COMPILE_AND_EXECUTE) &&
                     !c.state().lists().compiling && !c.state().immediate().open;
  if (!valid) {
    c.gl().NewList(name, mode);  // raises the error
    return;
  }
  c.state().lists() = ListCompilation{};
  c.state().lists().name = name;
  c.state().lists().mode = mode;
  c.state().lists().cutting = c.stages() != nullptr && (c.options().transparent || c.ark().pool_level >= 0);
  c.state().lists().compiling = true;
  c.state().lists().changes_uniforms = false;
  c.state().immediate().vertices = 0;
  c.state().lists().list = std::make_shared<DisplayList>();
  if (!c.state().lists().cutting) {
    c.gl().NewList(name, mode);
    return;
  }
  open_segment(c, mode);
  c.update_refining();
}

void EndList(Context& c) {
  if (!c.state().lists().compiling) {
    c.gl().EndList();
    return;
  }
  end_list(c);
  if (const std::optional<GLuint> tag = std::exchange(c.ark().lowered_tag, std::nullopt)) DepthTag1i(c, *tag);
}

void CallList(Context& c, GLuint name) {
  if (!c.state().lists().compiling) {
    call_list(c, name, 0);
    track::follow_stack(c, name);
    return;
  }
  c.state().lists().list->calls_lists = true;
  if (!c.state().lists().in_begin) c.state().lists().list->stack_steps.push_back({StackStep::Kind::call, name});
  if (!c.state().lists().cutting || c.state().lists().in_begin) {
    c.state().lists().vertex_lists.push_back({name, false});
    c.gl().CallList(name);
    if (c.state().lists().mode == GL_COMPILE_AND_EXECUTE) track::follow_stack(c, name);
    return;
  }
  close_segment(c, {});
  c.state().lists().list->segments.push_back({.kind = ListSegment::Kind::call, .list = name});
  execute_last(c);
  open_segment(c, c.state().lists().mode);
}

void CallLists(Context& c, GLsizei n, GLenum type, const void* lists) {
  GLuint probe = 0;
  if (n < 1 || lists == nullptr || !decode_name(type, lists, 0, probe)) {
    c.gl().CallLists(n, type, lists);
    return;
  }
  if (c.state().lists().compiling) {
    record_calls(c, n, type, lists);
    return;
  }
  if (!c.refining() || c.state().immediate().open) {
    for (GLsizei i = 0; i < n && c.state().immediate().capturing; ++i) {
      c.state().immediate().vertices += vertices_of(c, track::list_base(c) + name_at(type, lists, i), 0);
    }
    c.gl().CallLists(n, type, lists);
    forget_state(c, nullptr);
    follow_stacks(c, n, type, lists);
    return;
  }
  for (GLsizei i = 0; i < n; ++i) {
    call_list(c, track::list_base(c) + name_at(type, lists, i), 0);
  }
  follow_stacks(c, n, type, lists);
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
      delete_segments(c, *list);
    }
  }
}

void ListBase(Context& c, GLuint base) {
  c.gl().ListBase(base);
  if (track::executes(c) && !c.state().immediate().open) {
    c.state().bindings().list_base = base;
  }
}

GLboolean IsList(Context& c, GLuint name) { return c.gl().IsList(name); }

}  // namespace hook
}  // namespace glark::core
