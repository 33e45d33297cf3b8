// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Paths of draws with the fixed function.
#include "conformance/random/immediate.h"

namespace glark::conformance {
namespace {

GLsizei any_count(World& w) { return w.values.coin() ? w.values.between(3, 40) : 12; }

// Calls `draw` with indices in the application's memory or in a buffer.
template <typename Draw>
void with_indices(World& w, const Draw& draw) {
  const std::size_t first = w.values.below(20);
  if (w.values.coin()) return draw(w.elements_memory.data() + first);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, w.elements);
  draw(reinterpret_cast<const void*>(short_indices + 2 * static_cast<GLintptr>(first)));
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void draw_arrays(World& w) {
  const GLenum mode = any_mode(w);
  const GLint first = w.values.between(0, 20);
  gl.DrawArrays(mode, first, any_count(w));
}

void draw_elements(World& w) {
  const GLenum mode = any_mode(w);
  const GLsizei count = any_count(w);
  with_indices(w, [&](const void* at) { gl.DrawElements(mode, count, GL_UNSIGNED_SHORT, at); });
}

void draw_range_elements(World& w) {
  const GLenum mode = any_mode(w);
  const GLsizei count = any_count(w);
  with_indices(
      w, [&](const void* at) { gl.DrawRangeElements(mode, 0, drawn_vertices - 1, count, GL_UNSIGNED_SHORT, at); });
}

void draw_base_vertex(World& w) {
  const GLenum mode = any_mode(w);
  const GLsizei count = any_count(w);
  const GLint base = w.values.pick({0, 2, 12, 40});
  const bool has_range = w.values.coin();
  with_indices(w, [&](const void* at) {
    if (has_range)
      gl.DrawRangeElementsBaseVertex(mode, 0, drawn_vertices - 1, count, GL_UNSIGNED_SHORT, at, base);
    else
      gl.DrawElementsBaseVertex(mode, count, GL_UNSIGNED_SHORT, at, base);
  });
}

void multi_draw_arrays(World& w) {
  const GLenum mode = any_mode(w);
  const std::array<GLint, 2> first = {w.values.between(0, 20), w.values.between(0, 20)};
  const std::array<GLsizei, 2> count = {any_count(w), any_count(w)};
  gl.MultiDrawArrays(mode, first.data(), count.data(), 2);
}

void multi_draw_base_vertex(World& w) {
  const GLenum mode = any_mode(w);
  const std::array<const void*, 2> at = {w.elements_memory.data(), w.elements_memory.data() + w.values.below(20)};
  const std::array<GLsizei, 2> count = {any_count(w), any_count(w)};
  const std::array<GLint, 2> base = {w.values.pick({0, 2, 12}), w.values.pick({0, 40})};
  gl.MultiDrawElementsBaseVertex(mode, count.data(), GL_UNSIGNED_SHORT, at.data(), 2, base.data());
}

// Commands in the application's memory, which only the compatibility profile has.
void draw_indirect(World& w) {
  const GLenum mode = any_mode(w);
  std::array<GLuint, 16> words{};
  for (const std::size_t at : {0U, 8U}) {
    words[at] = static_cast<GLuint>(any_count(w));
    words[at + 1] = 1;
    words[at + 2] = static_cast<GLuint>(w.values.between(0, 20));
  }
  if (w.values.coin()) return gl.DrawArraysIndirect(mode, words.data());
  gl.MultiDrawArraysIndirect(mode, words.data(), 2, 32);
}

void array_elements(World& w) {
  const GLsizei count = any_count(w);
  gl.Begin(any_mode(w));
  for (GLsizei i = 0; i < count; ++i) {
    if (w.values.below(6) == 0) random_vertices(w, 1);
    gl.ArrayElement(i * 5 % drawn_vertices);
  }
  gl.End();
}

void call_lists(World& w) {
  const std::array<GLubyte, 3> bytes = {first_list, last_list, first_list + 1};
  const std::array<GLshort, 3> shorts = {last_list, first_list, first_list + 2};
  if (w.values.coin())
    gl.CallLists(w.values.between(1, 3), GL_UNSIGNED_BYTE, bytes.data());
  else
    gl.CallLists(w.values.between(1, 3), GL_SHORT, shorts.data());
}

void list_within_begin(World& w) {
  gl.Begin(any_mode(w));
  random_vertices(w, w.values.between(1, 4));
  gl.CallList(w.values.coin() ? vertex_list : nested_vertex_list);
  random_vertices(w, w.values.between(0, 3));
  gl.End();
}

void conditional(World& w) {
  gl.BeginConditionalRender(w.queries[w.values.below(2)],
                            w.values.pick<GLenum>({GL_QUERY_WAIT, GL_QUERY_BY_REGION_WAIT}));
  random_primitive(w, 9);
  if (w.values.coin()) draw_arrays(w);
  gl.EndConditionalRender();
}

void draw_arp(World& w) {
  const bool is_refined = gl.IsEnabled(GL_ARK) == GL_TRUE;
  if (!is_refined) return draw_elements(w);
  gl.Disable(GL_ARK);
  const GLenum mode = any_mode(w);
  const GLsizei count = any_count(w);
  with_indices(w, [&](const void* at) { gl.DrawARPElementsARK(mode, count, GL_UNSIGNED_SHORT, at); });
  gl.Enable(GL_ARK);
}

}  // namespace

std::vector<RandomPath> fixed_paths() {
  using enum Where;
  const auto path = [](const char* name, void (*draw)(World&)) { return RandomPath{name, fixed, draw, compat_only}; };
  return {
      path("Begin", [](World& w) { random_primitive(w, 12); }),
      path("Begin of many", [](World& w) { random_primitive(w, 80); }),
      path("two of Begin",
           [](World& w) {
             random_primitive(w, 6);
             random_primitive(w, 6);
           }),
      path("DrawArrays of client arrays", draw_arrays),
      path("DrawElements of client arrays", draw_elements),
      path("DrawRangeElements of client arrays", draw_range_elements),
      path("DrawElementsBaseVertex of client arrays", draw_base_vertex),
      path("MultiDrawArrays of client arrays", multi_draw_arrays),
      path("MultiDrawElementsBaseVertex of client arrays", multi_draw_base_vertex),
      path("MultiDrawArraysIndirect of client commands", draw_indirect),
      path("ArrayElement among vertices", array_elements),
      path("CallList", [](World& w) { gl.CallList(static_cast<GLuint>(w.values.between(first_list, last_list))); }),
      path("CallLists", call_lists),
      path("CallList within Begin", list_within_begin),
      path("BeginConditionalRender of Begin", conditional),
      path("DrawARPElementsARK of client arrays", draw_arp),
  };
}

}  // namespace glark::conformance
