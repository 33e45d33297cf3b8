// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Paths of draws with programs. All indices and vertices that they read exist.
#include "conformance/random/immediate.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

// Indices of one type in World::elements. The bytes may hold the index 255, which is a vertex or a restart.
struct Indices {
  GLenum type;
  GLintptr offset;
  GLsizei count;
  const void* at() const { return reinterpret_cast<const void*>(offset); }
};

Indices any_indices(World& w) {
  const int first = 3 * w.values.between(0, 6);
  const GLsizei count = w.values.below(5) == 0 ? w.values.between(3, 60) : 3 * w.values.between(1, 20);
  switch (w.values.below(4)) {
    case 0: return {GL_UNSIGNED_BYTE, first, count};
    case 1: return {GL_UNSIGNED_BYTE, restart_bytes + first, count};
    case 2: return {GL_UNSIGNED_SHORT, short_indices + 2 * first, count};
    default: return {GL_UNSIGNED_INT, integer_indices + 4 * first, count};
  }
}

GLsizei any_count(World& w) { return w.values.below(5) == 0 ? w.values.between(3, 60) : 3 * w.values.between(1, 20); }
GLint any_first(World& w) { return w.values.between(0, 20); }
// The least index is 0, so a base vertex is not negative.
GLint any_base(World& w) { return w.values.pick({0, 1, 3, 24}); }

void draw_arrays(World& w) {
  const GLenum mode = any_mode(w);
  const GLint first = any_first(w);
  gl.DrawArrays(mode, first, any_count(w));
}

void draw_elements(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  gl.DrawElements(mode, i.count, i.type, i.at());
}

void draw_range_elements(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  gl.DrawRangeElements(mode, 0, 255, i.count, i.type, i.at());
}

void draw_elements_base_vertex(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  gl.DrawElementsBaseVertex(mode, i.count, i.type, i.at(), any_base(w));
}

void draw_range_base_vertex(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  gl.DrawRangeElementsBaseVertex(mode, 0, 255, i.count, i.type, i.at(), any_base(w));
}

void draw_arrays_instanced(World& w) {
  const GLenum mode = any_mode(w);
  const GLint first = any_first(w);
  gl.DrawArraysInstanced(mode, first, any_count(w), w.values.between(1, 3));
}

void draw_elements_instanced(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  if (w.values.coin())
    gl.DrawElementsInstanced(mode, i.count, i.type, i.at(), w.values.between(1, 3));
  else
    gl.DrawElementsInstancedBaseVertex(mode, i.count, i.type, i.at(), w.values.between(1, 2), any_base(w));
}

void draw_base_instance(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  const auto instance = static_cast<GLuint>(w.values.between(0, 5));
  const GLsizei instances = w.values.between(1, 2);
  switch (w.values.below(3)) {
    case 0: gl.DrawArraysInstancedBaseInstance(mode, any_first(w), i.count, instances, instance); break;
    case 1: gl.DrawElementsInstancedBaseInstance(mode, i.count, i.type, i.at(), instances, instance); break;
    default:
      gl.DrawElementsInstancedBaseVertexBaseInstance(mode, i.count, i.type, i.at(), instances, any_base(w), instance);
      break;
  }
}

void multi_draw_arrays(World& w) {
  const GLenum mode = any_mode(w);
  const std::array<GLint, 3> first = {any_first(w), any_first(w), any_first(w)};
  const std::array<GLsizei, 3> count = {3, w.values.pick({0, 6}), any_count(w)};
  gl.MultiDrawArrays(mode, first.data(), count.data(), w.values.between(1, 3));
}

void multi_draw_elements(World& w) {
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  const std::array<const void*, 2> first = {i.at(), nullptr};
  const std::array<GLsizei, 2> count = {i.count, i.type == GL_UNSIGNED_BYTE ? 9 : 0};
  const std::array<GLint, 2> base = {any_base(w), any_base(w)};
  if (w.values.coin())
    gl.MultiDrawElements(mode, count.data(), i.type, first.data(), 2);
  else
    gl.MultiDrawElementsBaseVertex(mode, count.data(), i.type, first.data(), 2, base.data());
}

const void* any_arrays_command(World& w) { return reinterpret_cast<const void*>(32 * w.values.below(2)); }
const void* any_elements_command(World& w) { return reinterpret_cast<const void*>(128 + 32 * w.values.below(2)); }

// The offset of the first index is 0 in each command: bytes.
void draw_indirect(World& w) {
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, w.commands);
  const GLenum mode = any_mode(w);
  if (w.values.coin())
    gl.DrawArraysIndirect(mode, any_arrays_command(w));
  else
    gl.DrawElementsIndirect(mode, GL_UNSIGNED_BYTE, any_elements_command(w));
}

void multi_draw_indirect(World& w) {
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, w.commands);
  const GLenum mode = any_mode(w);
  const GLsizei count = w.values.between(1, 2);
  const GLsizei stride = w.values.pick({32, 64});
  if (w.values.coin())
    gl.MultiDrawArraysIndirect(mode, any_arrays_command(w), count, stride == 64 ? 32 : stride);
  else
    gl.MultiDrawElementsIndirect(mode, GL_UNSIGNED_BYTE, any_elements_command(w), count, 32);
}

// Not refined while ARK is disabled, as all other paths.
void draw_arp(World& w) {
  if (gl.IsEnabled(GL_ARK) == GL_FALSE) return draw_arrays(w);
  gl.Disable(GL_ARK);
  const GLenum mode = any_mode(w);
  const GLint first = any_first(w);
  gl.DrawARP(mode, first, any_count(w));
  gl.Enable(GL_ARK);
}

void draw_arp_elements(World& w) {
  if (gl.IsEnabled(GL_ARK) == GL_FALSE) return draw_elements(w);
  gl.Disable(GL_ARK);
  const GLenum mode = any_mode(w);
  const Indices i = any_indices(w);
  gl.DrawARPElementsARK(mode, i.count, i.type, i.at());
  gl.Enable(GL_ARK);
}

void conditional(World& w) {
  gl.BeginConditionalRender(w.queries[w.values.below(2)],
                            w.values.pick<GLenum>({GL_QUERY_WAIT, GL_QUERY_BY_REGION_WAIT, GL_QUERY_WAIT_INVERTED}));
  draw_arrays(w);
  if (w.values.coin()) draw_elements(w);
  gl.EndConditionalRender();
}

// Draws that feedback captures, and others while it is paused. An implementation may leave some of them unrefined.
void captured(World& w) {
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, w.captured);
  gl.BeginTransformFeedback(GL_TRIANGLES);
  for (int i = w.values.between(0, 2); i > 0; --i) draw_arrays(w);
  gl.PauseTransformFeedback();
  for (int i = w.values.between(0, 2); i > 0; --i) w.values.coin() ? draw_arrays(w) : draw_elements(w);
  if (w.values.coin()) {
    gl.ResumeTransformFeedback();
    draw_arrays(w);
  }
  gl.EndTransformFeedback();
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
}

// Edges and corners are drawn. At the depth 0 they are those of the coarse triangles.
void outlined(World& w) {
  const GLint source = integer_of(GL_DEPTH_SOURCE_ARK);
  const GLint level = integer_of(GL_UNIFORM_DEPTH_LEVEL_ARK);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
  gl.PolygonMode(GL_FRONT_AND_BACK, w.values.pick<GLenum>({GL_LINE, GL_LINE, GL_POINT}));
  w.values.coin() ? draw_arrays(w) : draw_elements(w);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, source);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, level);
}

// Two commands for one picture: the second one reads what the first one has left.
void draw_twice(World& w) {
  draw_arrays(w);
  draw_elements(w);
}

void array_elements(World& w) {
  const Indices i = any_indices(w);
  gl.Begin(any_mode(w));
  for (GLsizei k = 0; k < i.count; ++k) gl.ArrayElement(k * 5 % drawn_vertices);
  gl.End();
}

}  // namespace

std::vector<RandomPath> stage_paths() {
  using enum Where;
  return {
      {"DrawArrays", shader, draw_arrays},
      {"DrawElements", shader, draw_elements},
      {"DrawRangeElements", shader, draw_range_elements},
      {"DrawElementsBaseVertex", shader, draw_elements_base_vertex},
      {"DrawRangeElementsBaseVertex", shader, draw_range_base_vertex},
      {"DrawArraysInstanced", shader, draw_arrays_instanced},
      {"DrawElementsInstanced", shader, draw_elements_instanced},
      {"DrawElementsInstancedBaseInstance", shader, draw_base_instance, desktop_apis},
      {"MultiDrawArrays", shader, multi_draw_arrays, desktop_apis},
      {"MultiDrawElements", shader, multi_draw_elements, desktop_apis},
      {"DrawArraysIndirect", shader, draw_indirect},
      {"MultiDrawElementsIndirect", shader, multi_draw_indirect, desktop_apis},
      {"DrawARP", shader, draw_arp},
      {"DrawARPElementsARK", shader, draw_arp_elements},
      {"BeginConditionalRender", shader, conditional, desktop_apis},
      {"two draws", shader, draw_twice},
      {"BeginTransformFeedback and pause", shader, captured, desktop_apis, 0, true},
      {"PolygonMode at the depth 0", shader, outlined, desktop_apis, 0, true},
      {"ArrayElement", shader, array_elements, compat_only},
  };
}

}  // namespace glark::conformance
