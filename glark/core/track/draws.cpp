// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of the draw calls whose counts the CPU knows. Each turns its arguments into a DrawCall.
#include <algorithm>
#include <optional>

#include "glark/core/objects/get_integer.h"
#include "glark/core/track/filled_draws.h"
#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace track {

void refine(Context& context, const DrawCall& call) {
  context.stages()->draw().run(call);
  context.update_refining();
}

void leave(Context& context, const DrawCall& call, Cause cause) {
  context.stages()->draw().leave(call, cause);
  context.update_refining();
}

// Such a call draws nothing: the application's transform feedback may stay ours.
void refused(Context& context, const Issue& issue) {
  if (context.state().lists().compiling()) {
    draw(context, {.mode = GL_POINTS, .issue = issue});
  } else {
    issue();
  }
}

void hand_back_feedback(Context& context) {
  context.stages()->feedback().hand_back();
  context.update_refining();
}

void draw(Context& context, const DrawCall& call) {
  if (context.state().lists().compiling()) {
    if (context.state().lists().cutting()) {
      record_draw(context, call);
    } else {
      call.issue();
    }
    return;
  }
  refine(context, call);
}

bool restarts_at_vertex(Context& context, std::uint64_t end) {
  context.state().refresh();
  const Bindings& b = context.state().bindings();
  return b.primitive_restart && !b.primitive_restart_fixed &&
         static_cast<GLuint>(get_integer(context.gl(), GL_PRIMITIVE_RESTART_INDEX)) < end;
}

namespace {

bool restarts(Context& context) {
  context.state().refresh();
  return context.state().bindings().primitive_restart || context.state().bindings().primitive_restart_fixed;
}

// The polygons of several commands or instances, if they may be split at their centroids.
class Polygons {
 public:
  Polygons(const Context& context, GLenum mode)
      : wanted_(mode == GL_POLYGON && splits_polygons(context.options(), context.ark())),
        in_list_(context.state().lists().cutting()) {}
  void add(GLsizei vertices, GLsizei instances = 1) {
    constexpr std::size_t most = std::size_t{1} << 22;  // more polygons stay triangles
    wanted_ = wanted_ && sides_.size() + static_cast<std::size_t>(instances) <= most;
    if (wanted_ && vertices >= 3) {
      sides_.insert(sides_.end(), static_cast<std::size_t>(instances), static_cast<std::uint32_t>(vertices));
    }
    // Mesa 22 turns a polygon of two vertices in a list into a triangle.
    wanted_ = wanted_ && !(in_list_ && vertices > 0 && vertices < 3);
  }
  const PolygonSides* sides() const { return sides_.empty() || !wanted_ ? nullptr : &sides_; }

 private:
  bool wanted_;
  bool in_list_;
  PolygonSides sides_;
};

Polygons polygons_of(const Context& context, const ArrayDraw& draw_of) {
  Polygons polygons(context, draw_of.mode);
  if (draw_of.instances > 1) {
    polygons.add(draw_of.count, draw_of.instances);
  }
  return polygons;
}

Polygons polygons_of(const Context& context, GLenum mode, const GLsizei* count, GLsizei draws) {
  Polygons polygons(context, mode);
  for (GLsizei i = 0; i < draws; ++i) {
    polygons.add(count[i]);
  }
  return polygons;
}

// One array draw; `issue` is the application's own call.
void draw_arrays(Context& context, const ArrayDraw& draw_of, Issue issue) {
  if (draw_of.first < 0 || draw_of.count < 0 || draw_of.instances < 0) {
    issue();  // GL_INVALID_VALUE
    return;
  }
  const std::uint64_t triangles = triangles_of(draw_of.mode, static_cast<std::uint64_t>(draw_of.count)) *
                                  static_cast<std::uint64_t>(draw_of.instances);
  const bool exact = !restarts_at_vertex(
      context, static_cast<std::uint64_t>(draw_of.first) + static_cast<std::uint64_t>(draw_of.count));
  const Polygons polygons = exact ? polygons_of(context, draw_of) : Polygons(context, GL_TRIANGLES);
  draw(context, {.mode = draw_of.mode,
                 .triangles = triangles,
                 .exact = exact,
                 .whole_polygons = tells_polygons_apart(draw_of.mode, static_cast<std::uint64_t>(draw_of.instances)),
                 .polygon_sides = polygons.sides(),
                 .from_arrays = true,
                 .arrays = exact ? &draw_of : nullptr,
                 .issue = issue});
}

void draw_elements(Context& context, const ArrayDraw& draw_of, Issue issue) {
  if (draw_of.count < 0 || draw_of.instances < 0 || !is_index_type(draw_of.index_type)) {
    issue();  // GL_INVALID_VALUE, GL_INVALID_ENUM
    return;
  }
  context.state().refresh();
  const std::uint64_t triangles = triangles_of(draw_of.mode, static_cast<std::uint64_t>(draw_of.count)) *
                                  static_cast<std::uint64_t>(draw_of.instances);
  const bool exact = !restarts(context);
  const Polygons polygons = exact ? polygons_of(context, draw_of) : Polygons(context, GL_TRIANGLES);
  draw(context, {.mode = draw_of.mode,
                 .triangles = triangles,
                 .exact = exact,
                 .whole_polygons = tells_polygons_apart(draw_of.mode, static_cast<std::uint64_t>(draw_of.instances)),
                 .polygon_sides = polygons.sides(),
                 .from_arrays = true,
                 .indexed = true,
                 .arrays = &draw_of,
                 .issue = issue});
}

std::uint64_t triangles_of_all(GLenum mode, const GLsizei* count, GLsizei draws) {
  std::uint64_t total = 0;
  for (GLsizei i = 0; i < draws; ++i) {
    if (count[i] < 0) {
      return 0;
    }
    total += triangles_of(mode, static_cast<std::uint64_t>(count[i]));
  }
  return total;
}

// One past the greatest vertex of all draws.
std::uint64_t end_of_all(const GLint* first, const GLsizei* count, GLsizei draws) {
  std::uint64_t end = 0;
  for (GLsizei i = 0; i < draws; ++i) {
    const auto sum = std::int64_t{first[i]} + count[i];
    end = count[i] > 0 && sum > 0 ? std::max(end, static_cast<std::uint64_t>(sum)) : end;
  }
  return end;
}

// Only the GPU knows the number of vertices; the buffers that they were captured to give a bound.
void draw_feedback(Context& context, GLenum mode, GLuint id, GLsizei instances, Issue issue) {
  context.stages()->draw().begin_counted();
  const std::optional<std::uint64_t> vertices = context.stages()->feedback().room().vertices(id);
  if (instances < 0 || mode > GL_PATCHES ||
      (!vertices && context.gl().IsTransformFeedback(id) == GL_FALSE && id != 0)) {
    refused(context, issue);
    return;
  }
  if (!vertices) {
    leave(context, {.mode = mode, .from_arrays = true, .issue = issue}, Cause::indirect_unbounded);
    return;
  }
  draw(context, {.mode = mode,
                 .triangles = triangles_of(mode, *vertices) * static_cast<std::uint64_t>(instances),
                 .exact = false,
                 .whole_polygons = mode != GL_POLYGON,
                 .from_arrays = true,
                 .issue = issue});
}

// The extension does not refine rectangles and evaluator meshes. Transparent refinement treats them as triangles.
void draw_shape(Context& context, DrawCall call) {
  if (!context.options().transparent) {
    call.never_refined = true;
    context.state().lists().effects().draws_shapes = true;
  }
  draw(context, call);
}

void draw_rectangle(Context& context, Issue issue) {
  draw_shape(context, {.mode = GL_QUADS, .triangles = 2, .issue = issue});
}

}  // namespace
}  // namespace track

namespace hook {
namespace {

// Mesa 22 joins the strips of one list by triangles without area.
bool joins_strips(const Context& c, GLenum mode, GLsizei draws) {
  return c.state().lists().compiling() && mode == GL_TRIANGLE_STRIP && draws > 1;
}

// Lists of draws from an index array. `filled` makes the same triangles, without empty draws.
void draw_index_lists(Context& c, GLenum mode, const GLsizei* count, GLsizei draws, const Issue& issue,
                      const Issue* filled) {
  c.state().refresh();
  const bool exact = !track::restarts(c) && !joins_strips(c, mode, draws);
  const track::Polygons polygons = track::polygons_of(c, mode, count, exact ? draws : 0);
  track::draw(c, {.mode = mode,
                  .triangles = track::triangles_of_all(mode, count, draws),
                  .exact = exact,
                  .whole_polygons = tells_polygons_apart(mode, static_cast<std::uint64_t>(draws)),
                  .polygon_sides = polygons.sides(),
                  .from_arrays = true,
                  .indexed = true,
                  .issue = issue,
                  .captured = filled});
}

}  // namespace

using track::draw_arrays;
using track::draw_elements;

void DrawArrays(Context& c, GLenum mode, GLint first, GLsizei count) {
  draw_arrays(c, {.mode = mode, .first = first, .count = count}, [&] { c.gl().DrawArrays(mode, first, count); });
}

void DrawArraysInstanced(Context& c, GLenum mode, GLint first, GLsizei count, GLsizei instances) {
  draw_arrays(c, {.mode = mode, .first = first, .count = count, .instances = instances},
              [&] { c.gl().DrawArraysInstanced(mode, first, count, instances); });
}

void DrawArraysInstancedBaseInstance(Context& c, GLenum mode, GLint first, GLsizei count, GLsizei instances,
                                     GLuint base_instance) {
  draw_arrays(c, {.mode = mode, .first = first, .count = count, .instances = instances, .base_instance = base_instance},
              [&] { c.gl().DrawArraysInstancedBaseInstance(mode, first, count, instances, base_instance); });
}

void DrawElements(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  draw_elements(c, {.mode = mode, .count = count, .index_type = type, .indices = indices},
                [&] { c.gl().DrawElements(mode, count, type, indices); });
}

void DrawRangeElements(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices) {
  draw_elements(c, {.mode = mode, .count = count, .index_type = type, .indices = indices},
                [&] { c.gl().DrawRangeElements(mode, start, end, count, type, indices); });
}

void DrawElementsBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                            GLint base_vertex) {
  draw_elements(c, {.mode = mode, .count = count, .index_type = type, .indices = indices, .base_vertex = base_vertex},
                [&] { c.gl().DrawElementsBaseVertex(mode, count, type, indices, base_vertex); });
}

void DrawRangeElementsBaseVertex(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                                 const void* indices, GLint base_vertex) {
  draw_elements(c, {.mode = mode, .count = count, .index_type = type, .indices = indices, .base_vertex = base_vertex},
                [&] { c.gl().DrawRangeElementsBaseVertex(mode, start, end, count, type, indices, base_vertex); });
}

void DrawElementsInstanced(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                           GLsizei instances) {
  draw_elements(c, {.mode = mode, .count = count, .index_type = type, .indices = indices, .instances = instances},
                [&] { c.gl().DrawElementsInstanced(mode, count, type, indices, instances); });
}

void DrawElementsInstancedBaseInstance(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                                       GLsizei instances, GLuint base_instance) {
  draw_elements(
      c,
      {.mode = mode,
       .count = count,
       .index_type = type,
       .indices = indices,
       .instances = instances,
       .base_instance = base_instance},
      [&] { c.gl().DrawElementsInstancedBaseInstance(mode, count, type, indices, instances, base_instance); });
}

void DrawElementsInstancedBaseVertex(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices,
                                     GLsizei instances, GLint base_vertex) {
  draw_elements(c,
                {.mode = mode,
                 .count = count,
                 .index_type = type,
                 .indices = indices,
                 .base_vertex = base_vertex,
                 .instances = instances},
                [&] { c.gl().DrawElementsInstancedBaseVertex(mode, count, type, indices, instances, base_vertex); });
}

void DrawElementsInstancedBaseVertexBaseInstance(Context& c, GLenum mode, GLsizei count, GLenum type,
                                                 const void* indices, GLsizei instances, GLint base_vertex,
                                                 GLuint base_instance) {
  const ArrayDraw draw_of{.mode = mode,
                          .count = count,
                          .index_type = type,
                          .indices = indices,
                          .base_vertex = base_vertex,
                          .instances = instances,
                          .base_instance = base_instance};
  draw_elements(c, draw_of, [&] {
    c.gl().DrawElementsInstancedBaseVertexBaseInstance(mode, count, type, indices, instances, base_vertex,
                                                       base_instance);
  });
}

void MultiDrawArrays(Context& c, GLenum mode, const GLint* first, const GLsizei* count, GLsizei draws) {
  const track::FilledDraws filled(mode, count, draws);
  const auto draw_filled = [&] {
    c.gl().MultiDrawArrays(mode, filled.arguments(first).data(), filled.counts(), draws);
  };
  const Issue captured(draw_filled);
  const bool restarts = track::restarts_at_vertex(c, track::end_of_all(first, count, draws));
  const track::Polygons polygons = track::polygons_of(c, mode, count, restarts ? 0 : draws);
  track::draw(c, {.mode = mode,
                  .triangles = track::triangles_of_all(mode, count, draws),
                  .exact = !restarts && !joins_strips(c, mode, draws),
                  .whole_polygons = tells_polygons_apart(mode, static_cast<std::uint64_t>(draws)),
                  .polygon_sides = polygons.sides(),
                  .from_arrays = true,
                  .issue = [&] { c.gl().MultiDrawArrays(mode, first, count, draws); },
                  .captured = filled.needed() ? &captured : nullptr});
}

void MultiDrawElements(Context& c, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                       GLsizei draws) {
  const track::FilledDraws filled(mode, count, draws);
  const auto draw_filled = [&] {
    c.gl().MultiDrawElements(mode, filled.counts(), type, filled.arguments(indices).data(), draws);
  };
  const Issue captured(draw_filled);
  draw_index_lists(
      c, mode, count, draws, [&] { c.gl().MultiDrawElements(mode, count, type, indices, draws); },
      filled.needed() ? &captured : nullptr);
}

void MultiDrawElementsBaseVertex(Context& c, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                                 GLsizei draws, const GLint* base_vertex) {
  const track::FilledDraws filled(mode, count, draws);
  const auto draw_filled = [&] {
    c.gl().MultiDrawElementsBaseVertex(mode, filled.counts(), type, filled.arguments(indices).data(), draws,
                                       filled.arguments(base_vertex).data());
  };
  const Issue captured(draw_filled);
  draw_index_lists(
      c, mode, count, draws,
      [&] { c.gl().MultiDrawElementsBaseVertex(mode, count, type, indices, draws, base_vertex); },
      filled.needed() ? &captured : nullptr);
}

void Rectd(Context& c, GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2) {
  track::draw_rectangle(c, [&] { c.gl().Rectd(x1, y1, x2, y2); });
}
void Rectdv(Context& c, const GLdouble* v1, const GLdouble* v2) {
  track::draw_rectangle(c, [&] { c.gl().Rectdv(v1, v2); });
}
void Rectf(Context& c, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2) {
  track::draw_rectangle(c, [&] { c.gl().Rectf(x1, y1, x2, y2); });
}
void Rectfv(Context& c, const GLfloat* v1, const GLfloat* v2) {
  track::draw_rectangle(c, [&] { c.gl().Rectfv(v1, v2); });
}
void Recti(Context& c, GLint x1, GLint y1, GLint x2, GLint y2) {
  track::draw_rectangle(c, [&] { c.gl().Recti(x1, y1, x2, y2); });
}
void Rectiv(Context& c, const GLint* v1, const GLint* v2) {
  track::draw_rectangle(c, [&] { c.gl().Rectiv(v1, v2); });
}
void Rects(Context& c, GLshort x1, GLshort y1, GLshort x2, GLshort y2) {
  track::draw_rectangle(c, [&] { c.gl().Rects(x1, y1, x2, y2); });
}
void Rectsv(Context& c, const GLshort* v1, const GLshort* v2) {
  track::draw_rectangle(c, [&] { c.gl().Rectsv(v1, v2); });
}

void EvalMesh1(Context& c, GLenum mode, GLint i1, GLint i2) {
  const GLenum points_or_lines = mode == GL_POINT ? GL_POINTS : GL_LINES;
  track::draw(c, {.mode = points_or_lines, .issue = [&] { c.gl().EvalMesh1(mode, i1, i2); }});
}

// OpenGL 4.6 compatibility, D.1: in mode GL_FILL a row of the mesh is a quad strip.
void EvalMesh2(Context& c, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
  const auto columns = static_cast<std::uint64_t>(std::max(0, i2 - i1));
  const auto rows = static_cast<std::uint64_t>(std::max(0, j2 - j1));
  const GLenum rows_of = mode == GL_FILL ? GL_QUAD_STRIP : mode == GL_LINE ? GL_LINES : GL_POINTS;
  track::draw_shape(c, {.mode = rows_of, .triangles = 2 * columns * rows, .exact = false, .issue = [&] {
                          c.gl().EvalMesh2(mode, i1, i2, j1, j2);
                        }});
}

void DrawTransformFeedback(Context& c, GLenum mode, GLuint id) {
  track::draw_feedback(c, mode, id, 1, [&] { c.gl().DrawTransformFeedback(mode, id); });
}
void DrawTransformFeedbackInstanced(Context& c, GLenum mode, GLuint id, GLsizei instances) {
  track::draw_feedback(c, mode, id, instances, [&] { c.gl().DrawTransformFeedbackInstanced(mode, id, instances); });
}
void DrawTransformFeedbackStream(Context& c, GLenum mode, GLuint id, GLuint stream) {
  track::draw_feedback(c, mode, id, 1, [&] { c.gl().DrawTransformFeedbackStream(mode, id, stream); });
}
void DrawTransformFeedbackStreamInstanced(Context& c, GLenum mode, GLuint id, GLuint stream, GLsizei instances) {
  track::draw_feedback(c, mode, id, instances,
                       [&] { c.gl().DrawTransformFeedbackStreamInstanced(mode, id, stream, instances); });
}

}  // namespace hook
}  // namespace glark::core
