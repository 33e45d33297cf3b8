// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/immediate.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace glark::conformance {
namespace {

// All commands for a vertex at integer coordinates, from -7 to 7.
template <auto Command, std::size_t n, typename T>
void vertex_by_scalars(const std::array<int, 4>& at) {
  if constexpr (n == 2)
    (gl.*Command)(static_cast<T>(at[0]), static_cast<T>(at[1]));
  else if constexpr (n == 3)
    (gl.*Command)(static_cast<T>(at[0]), static_cast<T>(at[1]), static_cast<T>(at[2]));
  else
    (gl.*Command)(static_cast<T>(at[0] * at[3]), static_cast<T>(at[1] * at[3]), static_cast<T>(at[2] * at[3]),
                  static_cast<T>(at[3]));
}

template <auto Command, std::size_t n, typename T>
void vertex_by_array(const std::array<int, 4>& at) {
  std::array<T, 4> values{};
  for (std::size_t i = 0; i < 3; ++i) values[i] = static_cast<T>(n == 4 ? at[i] * at[3] : at[i]);
  values[3] = static_cast<T>(at[3]);
  (gl.*Command)(values.data());
}

using G = GladGLContext;
using Vertex = void (*)(const std::array<int, 4>&);
constexpr Vertex vertex_commands[] = {
    vertex_by_scalars<&G::Vertex2s, 2, GLshort>, vertex_by_scalars<&G::Vertex2i, 2, GLint>,
    vertex_by_scalars<&G::Vertex2f, 2, GLfloat>, vertex_by_scalars<&G::Vertex2d, 2, GLdouble>,
    vertex_by_scalars<&G::Vertex3s, 3, GLshort>, vertex_by_scalars<&G::Vertex3i, 3, GLint>,
    vertex_by_scalars<&G::Vertex3f, 3, GLfloat>, vertex_by_scalars<&G::Vertex3d, 3, GLdouble>,
    vertex_by_scalars<&G::Vertex4s, 4, GLshort>, vertex_by_scalars<&G::Vertex4i, 4, GLint>,
    vertex_by_scalars<&G::Vertex4f, 4, GLfloat>, vertex_by_scalars<&G::Vertex4d, 4, GLdouble>,
    vertex_by_array<&G::Vertex2sv, 2, GLshort>,  vertex_by_array<&G::Vertex2iv, 2, GLint>,
    vertex_by_array<&G::Vertex2fv, 2, GLfloat>,  vertex_by_array<&G::Vertex2dv, 2, GLdouble>,
    vertex_by_array<&G::Vertex3sv, 3, GLshort>,  vertex_by_array<&G::Vertex3iv, 3, GLint>,
    vertex_by_array<&G::Vertex3fv, 3, GLfloat>,  vertex_by_array<&G::Vertex3dv, 3, GLdouble>,
    vertex_by_array<&G::Vertex4sv, 4, GLshort>,  vertex_by_array<&G::Vertex4iv, 4, GLint>,
    vertex_by_array<&G::Vertex4fv, 4, GLfloat>,  vertex_by_array<&G::Vertex4dv, 4, GLdouble>,
};

// Mesa keeps the components of a command of four where one of three or two follows before the next vertex, in lists and
// between Begin and End. So each value has only one size there.
bool has_common_size(const Row& row) {
  const std::string_view name = row.name;
  for (const std::string_view other : {"Color3", "TexCoord1"})
    if (name.starts_with(other) || name.starts_with(std::string("Multi") + std::string(other))) return false;
  return true;
}

using RowPointers = std::vector<const Row*>;
template <typename Condition>
RowPointers rows_that(const Condition& condition) {
  RowPointers rows;
  for (const Row& row : all_rows())
    if (condition(row)) rows.push_back(&row);
  return rows;
}

const Row& any_of(const RowPointers& rows, World& w) { return *rows[w.values.below(rows.size())]; }

void any_value(World& w) {
  static const RowPointers all =
      rows_that([](const Row& row) { return row.where == Where::within_begin && has_common_size(row); });
  any_of(all, w).make(w);
}

void any_listed(World& w) {
  static const RowPointers all = rows_that([](const Row& row) { return row.is_listed && has_common_size(row); });
  any_of(all, w).make(w);
}

// Mesa takes the vector from a vertex to a light without a division by the w of the vertex (fault `light_of_w` of
// tests/drivers), so there are other values of w only where no light has a position.
void any_vertex(World& w, std::array<int, 4> at) {
  if (w.kind == WorldKind::fixed) at[3] = 1;
  vertex_commands[w.values.below(std::size(vertex_commands))](at);
}

// The z is 0, which is also what a vertex without z has.
std::array<int, 4> convex_place(GLenum mode, int i) {
  constexpr int corners[8][2] = {{3, -7}, {7, -3}, {7, 3}, {3, 7}, {-3, 7}, {-7, 3}, {-7, -3}, {-3, -7}};
  if (mode == GL_POLYGON) return {corners[i][0], corners[i][1], 0, 2};
  if (mode == GL_QUADS)
    return {corners[2 * (i % 4) + i / 4 % 2][0], corners[2 * (i % 4) + i / 4 % 2][1], 0, 1 + i / 4 % 3};
  return {i / 2 % 14 - 7, i % 2 == 0 ? -5 : 4, 0, 3};
}

// State that is back to what it was where the block ends. Not current values and materials: in a list, Mesa loses what
// PopAttrib restores of them.
void restored_block(World& w) {
  const bool is_matrix = w.values.coin();
  if (is_matrix) {
    gl.MatrixMode(GL_MODELVIEW);
    gl.PushMatrix();
    gl.Translatef(w.values.number(), w.values.number(), 0);
  } else {
    gl.PushAttrib(w.values.pick<GLbitfield>({GL_FOG_BIT | GL_ENABLE_BIT, GL_FOG_BIT | GL_POLYGON_BIT}));
    gl.Enable(w.values.pick<GLenum>({GL_FOG, GL_CULL_FACE}));
  }
  if (w.values.coin()) random_primitive(w, 6);
  if (is_matrix)
    gl.PopMatrix();
  else
    gl.PopAttrib();
}

}  // namespace

GLenum any_mode(World& w) {
  return w.values.pick<GLenum>({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN});
}

void random_vertices(World& w, int count) {
  const std::size_t one_in = w.values.pick<std::size_t>({1, 2, 4});
  for (int i = 0; i < count; ++i) {
    if (w.values.below(one_in) == 0) any_value(w);
    any_vertex(w,
               {w.values.between(-7, 7), w.values.between(-7, 7), w.values.between(-2, 2), w.values.pick({1, 2, 3})});
  }
}

void random_primitive(World& w, int most_vertices) {
  const int count = w.values.between(3, most_vertices);
  const GLenum triangles = any_mode(w);
  const GLenum mode = w.kind == WorldKind::polygons
                          ? w.values.pick<GLenum>({triangles, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON})
                          : triangles;
  gl.Begin(mode);
  if (mode == GL_QUADS || mode == GL_QUAD_STRIP || mode == GL_POLYGON) {
    const std::size_t one_in = w.values.pick<std::size_t>({1, 3});
    for (int i = 0; i < (mode == GL_POLYGON ? std::min(count, 8) : count); ++i) {
      if (w.values.below(one_in) == 0) any_value(w);
      any_vertex(w, convex_place(mode, i));
    }
  } else {
    random_vertices(w, count);
  }
  gl.End();
}

void compile_random_list(World& w, GLuint name) {
  gl.NewList(name, w.values.below(3) == 0 ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
  for (int i = w.values.between(1, 4); i > 0; --i) {
    switch (w.values.below(6)) {
      case 0:
      case 1: random_primitive(w, 7); break;
      case 2: restored_block(w); break;
      case 3:
        if (name < last_list) gl.CallList(static_cast<GLuint>(w.values.between(static_cast<int>(name) + 1, last_list)));
        break;
      default: any_listed(w); break;
    }
  }
  gl.EndList();
}

namespace {

void compile_vertices(World& w) {
  gl.NewList(vertex_list, GL_COMPILE);
  random_vertices(w, w.values.between(2, 5));
  gl.EndList();
}

void compile_call(World& w) {
  gl.NewList(nested_vertex_list, GL_COMPILE);
  if (w.values.coin()) random_vertices(w, 1);
  gl.CallList(vertex_list);
  gl.EndList();
}

}  // namespace

Rows list_rows() {
  using enum Where;
  const auto row = [](const char* name, void (*make)(World&), Apis apis = compat_only) {
    return Row{name, "display lists", fixed, make, apis};
  };
  return {
      row("NewList",
          [](World& w) { compile_random_list(w, static_cast<GLuint>(w.values.between(first_list, last_list))); }),
      row("NewList of vertices", compile_vertices),
      row("NewList that calls", compile_call),
      row("CallList", [](World& w) { gl.CallList(static_cast<GLuint>(w.values.between(first_list, last_list))); }),
      row("DeleteLists",
          [](World& w) {
            const GLuint first = w.values.coin() ? first_list : last_list;
            gl.DeleteLists(first, w.values.between(1, 2));
          }),
      row("ListBase", [](World& w) { gl.ListBase(static_cast<GLuint>(w.values.between(0, 1))); }),
  };
}

}  // namespace glark::conformance
