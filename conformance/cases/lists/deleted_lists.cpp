// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Ranges of deleted display lists, and lists that call lists between Begin and End, to any depth.
#include <fmt/core.h>

#include "conformance/cases/cases.h"
#include "conformance/cases/lists/immediate_triangle.h"

namespace glark::conformance {
namespace {

constexpr GLuint first_list = 20;
constexpr GLuint list_count = 8;
constexpr GLuint calling_list = 40;  // calls all of them

void compile_all() {
  for (GLuint i = 0; i < list_count; ++i) {
    gl.NewList(first_list + i, GL_COMPILE);
    draw_immediate_triangle();
    gl.EndList();
  }
  gl.NewList(calling_list, GL_COMPILE);
  for (GLuint i = 0; i < list_count; ++i) gl.CallList(first_list + i);
  gl.EndList();
}

void call_all() {
  GLubyte names[list_count];
  for (GLuint i = 0; i < list_count; ++i) names[i] = static_cast<GLubyte>(i);
  gl.ListBase(first_list);
  gl.CallLists(list_count, GL_UNSIGNED_BYTE, names);
  gl.ListBase(0);
}

void expect_remaining(Test& t, const std::function<bool(GLuint)>& remains, const std::string& what) {
  GLuint total = 0;
  for (GLuint name = first_list; name < first_list + list_count; ++name) {
    const bool is_there = remains(name);
    total += is_there ? 16 : 0;
    t.expect_equal(gl.IsList(name) == GL_TRUE, is_there, fmt::format("{}: IsList({})", what, name));
    t.expect_equal(count_generated([=] { gl.CallList(name); }), is_there ? 16U : 0U,
                   fmt::format("{}: triangles of list {}", what, name));
  }
  t.expect_equal(count_generated(call_all), total, what + ": triangles of CallLists");
  t.expect_equal(count_generated([] { gl.CallList(calling_list); }), total,
                 what + ": triangles of a list that calls them");
}

struct ListRange {
  GLuint first;
  GLsizei count;
};
constexpr ListRange list_ranges[] = {{20, 1}, {23, 1}, {27, 1}, {20, 2}, {20, 3},  {22, 4},  {25, 3},
                                     {20, 8}, {18, 4}, {26, 9}, {20, 0}, {27, 13}, {12, 28}, {1, 38}};

void check_list_ranges(Test& t, bool were_drawn) {
  gl.UseProgram(colour_program(t));
  refine_uniformly(2);
  for (const ListRange& range : list_ranges)
    for (const bool is_compiling : {false, true}) {
      compile_all();
      const auto every = [](GLuint) { return true; };
      if (were_drawn) expect_remaining(t, every, "before");
      if (is_compiling) gl.NewList(50, GL_COMPILE);  // DeleteLists is executed all the same
      gl.DeleteLists(range.first, range.count);
      if (is_compiling) gl.EndList();
      const auto remains = [&](GLuint name) {
        return name < range.first || name - range.first >= static_cast<GLuint>(range.count);
      };
      expect_remaining(t, remains, fmt::format("{} lists from {}", range.count, range.first));
      // A new list with a deleted name, which the caller calls.
      gl.NewList(first_list + 3, GL_COMPILE);
      draw_immediate_triangle();
      draw_immediate_triangle();
      gl.EndList();
      t.expect_equal(count_generated([] { gl.CallList(first_list + 3); }), 32U, "triangles of a new list");
      gl.DeleteLists(1, 60);
      expect_remaining(
          t, [](GLuint) { return false; }, "all deleted");
    }
  compile_all();
  gl.DeleteLists(first_list, -3);
  t.expect_error(GL_INVALID_VALUE, "a negative range");
  expect_remaining(
      t, [](GLuint) { return true; }, "a negative range");
  t.expect_no_error("the lists");
}

// Vertices of triangles, the next ones of `next`.
void emit_vertices(int& next, int count) {
  for (int i = 0; i < count; ++i, ++next) {
    const int triangle = next / 3;
    const int whole_rows = triangle / 9;
    const auto cell = static_cast<float>(triangle % 9);
    const auto row = static_cast<float>(whole_rows);
    const float x = -0.9F + 0.2F * cell + (next % 3 == 1 ? 0.17F : 0);
    const float y = -0.9F + 0.15F * row + (next % 3 == 2 ? 0.13F : 0);
    gl.VertexAttrib4f(at_colour, static_cast<float>(next % 7) / 6, static_cast<float>(next % 5) / 4, 1, 1);
    gl.VertexAttrib4f(0, x, y, 0, 1);
  }
}

struct Nest {
  const char* leaf;
  int depth;   // lists that call each other
  int before;  // vertices of each list before the call, and after it
  int after;
  int innermost;            // vertices of the last list
  bool is_several = false;  // CallLists calls a list without vertices, then the next list
  bool is_outside = false;  // Begin and End are in no list
};

constexpr Nest nests[] = {{"one", 1, 0, 0, 300},
                          {"two", 2, 0, 0, 300},
                          {"three", 3, 0, 0, 300},
                          {"six", 6, 0, 0, 300},
                          {"with_vertices", 4, 30, 42, 90},
                          {"odd_vertices", 3, 40, 47, 126},
                          {"few_vertices", 5, 1, 2, 3},
                          {"several", 3, 3, 6, 282, true},
                          {"outside", 3, 0, 0, 300, false, true},
                          {"outside_several", 4, 12, 18, 180, true, true}};

int vertices_of_nest(const Nest& nest) { return (nest.depth - 1) * (nest.before + nest.after) + nest.innermost; }

constexpr GLuint first_of_nest = 60;
constexpr GLuint no_vertices = 90;

void compile_nest(const Nest& nest) {
  int next = 0;
  std::vector<int> places;  // where the vertices after each call begin
  gl.NewList(no_vertices, GL_COMPILE);
  gl.VertexAttrib1f(5, 0.5F);
  gl.EndList();
  for (int level = 0; level < nest.depth; ++level) {
    const bool is_last = level + 1 == nest.depth;
    gl.NewList(first_of_nest + static_cast<GLuint>(level), GL_COMPILE);
    emit_vertices(next, is_last ? nest.innermost : nest.before);
    if (!is_last) {
      const GLuint names[] = {no_vertices, first_of_nest + static_cast<GLuint>(level) + 1};
      nest.is_several ? gl.CallLists(2, GL_UNSIGNED_INT, names) : gl.CallList(names[1]);
      int later = vertices_of_nest(nest) - (level + 1) * nest.after;
      emit_vertices(later, nest.after);
    }
    gl.EndList();
  }
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  gl.CallList(first_of_nest);
  gl.End();
  gl.EndList();
}

void draw_nest(const Nest& nest) {
  if (!nest.is_outside) return gl.CallList(1);
  gl.Begin(GL_TRIANGLES);
  gl.CallList(first_of_nest);
  gl.End();
}

void check_nest(Test& t, const Nest& nest) {
  gl.UseProgram(colour_program(t));
  refine_uniformly(2);
  const auto draw = [&nest] { draw_nest(nest); };
  const auto expect_vertices = [&](int count, const std::string& what) {
    for (int again = 0; again < 3; ++again) {
      const Picture refined = picture_of(draw);
      t.expect_equal(count_generated(draw), static_cast<GLuint>(16 * (count / 3)), what + ": triangles");
      gl.Disable(GL_ARK);
      t.expect_same_picture(refined, picture_of(draw), what, 4, 80);
      gl.Enable(GL_ARK);
    }
  };
  compile_nest(nest);
  expect_vertices(vertices_of_nest(nest), "the first lists");
  // Another innermost list: the ones that call it are not compiled again.
  const auto innermost = first_of_nest + static_cast<GLuint>(nest.depth) - 1;
  const int more = nest.innermost + 60;
  gl.NewList(innermost, GL_COMPILE);
  int next = 0;
  emit_vertices(next, more);
  gl.EndList();
  expect_vertices(vertices_of_nest(nest) - nest.innermost + more, "more vertices in the last list");
  gl.DeleteLists(innermost, 1);
  expect_vertices(vertices_of_nest(nest) - nest.innermost, "without the last list");
  compile_nest(nest);
  expect_vertices(vertices_of_nest(nest), "the first lists again");
  t.expect_no_error("the lists");
}

}  // namespace

Cases deleted_lists_cases() {
  Cases cases;
  for (const bool were_drawn : {true, false})
    cases.push_back({.name = std::string("ark.list.deleted.") + (were_drawn ? "drawn" : "undrawn"),
                     .clauses = {"10.R.2-1", "chapter-21-4"},
                     .plan = "Delete list_ranges of eight lists, and call each list.",
                     .wrong = "A deleted list is still drawn, the last of the range for example, or another is not.",
                     .apis = compat_only,
                     .check = [were_drawn](Test& t) { check_list_ranges(t, were_drawn); }});
  for (const Nest& nest : nests)
    cases.push_back({.name = std::string("ark.list.nested.") + nest.leaf,
                     .clauses = {"10.R.2-1", "10.R.2-2", "chapter-21-4"},
                     .plan = "Between Begin and End, call a list with vertices that calls a list with vertices, and so "
                             "on; change the last one.",
                     .wrong = "Vertices of inner lists are lost or not refined.",
                     .apis = compat_only,
                     .check = [&nest](Test& t) { check_nest(t, nest); }});
  return cases;
}

}  // namespace glark::conformance
