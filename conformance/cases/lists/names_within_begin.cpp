// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// CallList and CallLists between Begin and End, of lists that call further ones by names of every type. How many vertices
// the primitive has depends on the list base at the call, which may differ from that at the compilation.
#include <fmt/core.h>

#include <array>
#include <bit>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLuint first_base = 600;
constexpr GLuint second_base = 4000;
constexpr GLuint compiled_base = 40;  // while lists are compiled
enum VertexCaller : GLuint { callers = 100, call_of_names, call_of_call, deep_call, tested_call, tested_inner };
constexpr GLuint unused_list = 99;
constexpr GLuint offset_of_names = 50;  // from each base
constexpr GLuint offset_of_pair = 51;

// Vertices on a circle, in order, so that polygons are convex.
void circle_vertices(int first, int count, float scale) {
  constexpr float places[12][2] = {{1, 0},  {0.9F, 0.5F},   {0.5F, 0.9F},   {0, 1},  {-0.5F, 0.9F}, {-0.9F, 0.5F},
                                   {-1, 0}, {-0.9F, -0.5F}, {-0.5F, -0.9F}, {0, -1}, {0.5F, -0.9F}, {0.9F, -0.5F}};
  for (int i = first; i < first + count; ++i) {
    gl.Color3f(static_cast<float>(i % 4) / 3, static_cast<float>(i % 3) / 2, 0.5F);
    gl.Vertex2f(scale * places[i % 12][0], scale * places[i % 12][1]);
  }
}

void compile_vertices(GLuint list, int first, int count, float scale) {
  gl.NewList(list, GL_COMPILE);
  circle_vertices(first, count, scale);
  gl.EndList();
}

// The lists 1, 2 and 3 of each base, and the same by names that only some types have.
void compile_vertex_lists() {
  compile_vertices(unused_list, 0, 3, 0.5F);  // Mesa 22.3 makes too many vertices of the first list of a context
  for (const auto& [base, scale] : {std::pair<GLuint, float>{first_base, 0.9F}, {second_base, 0.6F}}) {
    const bool is_first = base == first_base;
    compile_vertices(base + 1, 0, is_first ? 3 : 4, scale);
    compile_vertices(base + 2, is_first ? 7 : 8, is_first ? 5 : 4, scale);
    for (const GLuint third : {base + 3, base + 0x103, base - 2}) compile_vertices(third, is_first ? 3 : 4, 4, scale);
  }
  // Where the base counts for nothing, or is that of the compilation. Mesa 22.3 crashes while a primitive is compiled that
  // calls names without a list: it leaves the base out.
  for (const GLuint name : {1U, 2U, 3U, 0x103U, 0U - 2U}) {
    compile_vertices(name, 0, 1, 0.2F);
    compile_vertices(compiled_base + name, 2, 1, 0.2F);
  }
}

struct NameType {
  const char* leaf;
  GLenum type;
  std::array<GLubyte, 16> names;  // of 1, 3 and 2
  GLenum mode;
};

template <typename Number>
constexpr std::array<GLubyte, 16> encoded_names(Number third) {
  return std::bit_cast<std::array<GLubyte, 16>>([third] {
    std::array<Number, 16 / sizeof(Number)> numbers{};
    numbers[0] = 1;
    numbers[1] = third;
    numbers[2] = 2;
    return numbers;
  }());
}

constexpr NameType name_types[] = {
    {"byte", GL_BYTE, encoded_names<GLbyte>(-2), GL_TRIANGLES},
    {"unsigned_byte", GL_UNSIGNED_BYTE, encoded_names<GLubyte>(3), GL_TRIANGLE_FAN},
    {"short", GL_SHORT, encoded_names<GLshort>(-2), GL_POLYGON},
    {"unsigned_short", GL_UNSIGNED_SHORT, encoded_names<GLushort>(0x103), GL_TRIANGLES},
    {"int", GL_INT, encoded_names<GLint>(-2), GL_QUADS},
    {"unsigned_int", GL_UNSIGNED_INT, encoded_names<GLuint>(0x103), GL_TRIANGLE_STRIP},
    {"float", GL_FLOAT, encoded_names<GLfloat>(-2), GL_TRIANGLES},
    {"two_bytes", GL_2_BYTES, {0, 1, 1, 3, 0, 2}, GL_POLYGON},
    {"three_bytes", GL_3_BYTES, {0, 0, 1, 0, 1, 3, 0, 0, 2}, GL_TRIANGLES},
    {"four_bytes", GL_4_BYTES, {0, 0, 0, 1, 0, 0, 1, 3, 0, 0, 0, 2}, GL_TRIANGLE_FAN},
};

void call_names(const NameType& names) { gl.CallLists(3, names.type, names.names.data()); }

template <typename Commands>
void compile_caller(GLuint list, Commands commands) {
  gl.NewList(list, GL_COMPILE);
  commands();
  gl.EndList();
}

// Lists that call the names: directly, through a list, and through lists that are named from the base.
void compile_callers(const NameType& names) {
  const GLubyte offset[] = {offset_of_names};
  const GLushort pair[] = {1, 3};
  for (const GLuint list : {GLuint{call_of_names}, offset_of_names, compiled_base + offset_of_names,
                            first_base + offset_of_names, second_base + offset_of_names})
    compile_caller(list, [&] { call_names(names); });
  for (const GLuint base : {0U, compiled_base, first_base, second_base})
    compile_caller(base + offset_of_pair, [&] { gl.CallLists(2, GL_UNSIGNED_SHORT, pair); });
  compile_caller(call_of_call, [&] { gl.CallLists(1, GL_UNSIGNED_BYTE, offset); });
  compile_caller(deep_call, [] { gl.CallList(call_of_call); });
}

void within(GLenum mode, void (*calls)(const NameType&), const NameType& names) {
  gl.Begin(mode);
  calls(names);
  gl.End();
}

// What is called between Begin and End.
struct VertexCalls {
  const char* leaf;
  void (*call)(const NameType&);
};
constexpr VertexCalls vertex_calls[] = {
    {"names", call_names},
    {"list_of_names", [](const NameType&) { gl.CallList(call_of_names); }},
    {"deep", [](const NameType&) { gl.CallList(deep_call); }},
    {"pair_and_list",
     [](const NameType&) {
       const GLubyte twos[] = {0, offset_of_pair, 0, 2};
       gl.CallLists(2, GL_2_BYTES, twos);
     }},
    {"between_vertices",
     [](const NameType& names) {
       circle_vertices(0, 1, 0.3F);
       call_names(names);
       circle_vertices(11, 1, 0.8F);
       gl.CallList(deep_call);
     }},
};

// How the primitive comes to GL. `draw` is what the case calls, after `compile`.
struct PrimitiveWay {
  const char* leaf;
  void (*compile)(const VertexCalls& calls, const NameType& names);
  void (*draw)(const VertexCalls& calls, const NameType& names);
  bool sets_base = false;
};
constexpr auto draw_tested_call = [](const VertexCalls&, const NameType&) { gl.CallList(tested_call); };

constexpr PrimitiveWay primitive_ways[] = {
    {"direct", [](const VertexCalls&, const NameType&) {},
     [](const VertexCalls& calls, const NameType& names) { within(names.mode, calls.call, names); }},
    {"listed",
     [](const VertexCalls& calls, const NameType& names) {
       compile_caller(tested_call, [&] { within(names.mode, calls.call, names); });
     },
     draw_tested_call},
    {"listed_twice",
     [](const VertexCalls& calls, const NameType& names) {
       compile_caller(tested_inner, [&] { within(names.mode, calls.call, names); });
       compile_caller(tested_call, [&] {
         gl.CallList(tested_inner);
         within(GL_TRIANGLES, calls.call, names);
       });
     },
     draw_tested_call},
    {"based",
     [](const VertexCalls& calls, const NameType& names) {
       compile_caller(tested_call, [&] {
         gl.ListBase(second_base);
         within(names.mode, calls.call, names);
         gl.ListBase(first_base);
         within(names.mode, calls.call, names);
       });
     },
     draw_tested_call, true},
    {"based_by_list",
     [](const VertexCalls& calls, const NameType& names) {
       compile_caller(tested_inner, [] { gl.ListBase(second_base); });
       compile_caller(tested_call, [&] {
         gl.CallList(tested_inner);
         within(names.mode, calls.call, names);
       });
     },
     draw_tested_call, true},
};

void expect_vertices_called(Test& t, const std::function<void()>& draw, GLuint tag, bool is_counted,
                            const std::string& what) {
  gl.Disable(GL_ARK);
  const GLuint plain = count_generated(draw);
  const Picture expected = picture_of(draw);
  gl.Enable(GL_ARK);
  gl.DepthTag1i(tag);
  t.expect(plain > 0, what + ": something is drawn");
  for (int again = 0; again < 2; ++again) {
    const GLuint triangles = count_generated(draw);
    t.expect(!is_counted || triangles == plain << (2 * tag), what + ": triangles");
    t.expect_same_picture(picture_of(draw), expected, what, 4, 80);
  }
}

void check_vertices_called(Test& t, const VertexCalls& calls, const PrimitiveWay& way) {
  gl.ARKinit(3);
  gl.Enable(GL_ARK);
  GLuint tag = 0;
  for (const NameType& names : name_types) {
    compile_vertex_lists();
    gl.ListBase(compiled_base);
    compile_callers(names);
    way.compile(calls, names);
    const bool is_counted = names.mode != GL_QUADS && names.mode != GL_POLYGON;  // GL counts each of them once
    for (const GLuint base : {first_base, second_base}) {
      const std::string what = fmt::format("names of type {}, base {}", names.leaf, base);
      const auto draw = [&] {
        gl.ListBase(base);
        way.draw(calls, names);
      };
      tag = tag % 2 + 1;
      expect_vertices_called(t, draw, tag, is_counted, what);
      compile_vertices(base + 1, 1, base == first_base ? 6 : 2, 0.95F);  // a called list gets other vertices
      expect_vertices_called(t, draw, tag, is_counted, what + ", with other vertices");
    }
  }
  t.expect_no_error("the calls");
}

}  // namespace

Cases names_within_begin_cases() {
  Cases cases;
  for (const VertexCalls& calls : vertex_calls)
    for (const PrimitiveWay& way : primitive_ways)
      cases.push_back({.name = fmt::format("ark.list.within.{}.{}", calls.leaf, way.leaf),
                       .clauses = {"10.R.2-2", "chapter-21-4", "chapter-21-5"},
                       .plan = "Between Begin and End, call lists of vertices that call others by names of each type, "
                               "with two list bases. Compare triangles and picture with those of the unrefined draw.",
                       .wrong =
                           "Vertices of lists that are called by lists, or by the base of the compilation, are not "
                           "counted: triangles are missing.",
                       .apis = compat_only,
                       .check = [&calls, &way](Test& t) { check_vertices_called(t, calls, way); }});
  return cases;
}

}  // namespace glark::conformance
