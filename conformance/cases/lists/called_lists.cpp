// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Lists called by names of every type, lists that use other programs or set their uniforms, and lists whose vertices have
// tags of their own.
#include "conformance/cases/cases.h"
#include "conformance/cases/lists/immediate_triangle.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

template <typename Name>
void expect_called(Test& t, GLenum type, Name name, const std::string& what) {
  const Name names[] = {name};
  t.expect_equal(count_generated([&] { gl.CallLists(1, type, names); }), 16U, "triangles of a list called by " + what);
}

// ListBase lies above the list, so that names below zero reach it.
void check_negative_names(Test& t) {
  gl.UseProgram(colour_program(t));
  refine_uniformly(2);
  gl.NewList(40, GL_COMPILE);
  draw_immediate_triangle();
  gl.EndList();
  for (int again = 0; again < 3; ++again) {
    gl.ListBase(50);
    expect_called(t, GL_BYTE, GLbyte{-10}, "a byte below zero");
    expect_called(t, GL_SHORT, GLshort{-10}, "a short below zero");
    expect_called(t, GL_INT, GLint{-10}, "an int below zero");
    expect_called(t, GL_FLOAT, GLfloat{-10}, "a float below zero");
    gl.ListBase(30);
    expect_called(t, GL_UNSIGNED_BYTE, GLubyte{10}, "an unsigned byte");
    expect_called(t, GL_UNSIGNED_SHORT, GLushort{10}, "an unsigned short");
    expect_called(t, GL_UNSIGNED_INT, GLuint{10}, "an unsigned int");
    gl.ListBase(0U - 60000U);
    expect_called(t, GL_UNSIGNED_SHORT, GLushort{60040}, "a large unsigned short");
    gl.ListBase(0U - 200U);
    expect_called(t, GL_UNSIGNED_BYTE, GLubyte{240}, "a large unsigned byte");
  }
  t.expect_no_error("the calls");
}

enum class Kind { uniform_after, program_uniform, both_within };

// The list uses the second program, or sets its uniform, while the first one is in use. Both programs were drawn refined
// before.
void check_programs(Test& t, Kind kind) {
  GLuint programs[2] = {};
  for (GLuint& program : programs)
    program = build_program(t, {.vertex = "layout(location = 0) in vec4 position; uniform vec4 tint; out vec4 colour;\n"
                                          "void main() { colour = tint; gl_Position = position; }\n"});
  const GLint tint = gl.GetUniformLocation(programs[1], "tint");
  upload(one_triangle());
  refine_uniformly(2);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (const GLuint program : programs) {
    gl.UseProgram(program);
    gl.Uniform4f(tint, 1, 0, 0, 1);
    picture_of(draw);
  }
  gl.UseProgram(programs[0]);
  gl.NewList(1, GL_COMPILE);
  if (kind != Kind::program_uniform) gl.UseProgram(programs[1]);
  if (kind == Kind::both_within) gl.Uniform4f(tint, 0, 1, 0.5F, 1);
  if (kind == Kind::program_uniform) gl.ProgramUniform4f(programs[1], tint, 0, 1, 0.5F, 1);
  if (kind == Kind::both_within) gl.UseProgram(programs[0]);
  gl.EndList();
  for (int again = 0; again < 3; ++again) {
    gl.UseProgram(programs[0]);
    gl.ProgramUniform4f(programs[1], tint, 1, 0, 0, 1);
    gl.CallList(1);
    if (kind == Kind::uniform_after) gl.Uniform4f(tint, 0, 1, 0.5F, 1);
    for (const GLuint program : {programs[1], programs[0]}) {
      gl.UseProgram(program);
      const Picture refined = picture_of(draw);
      gl.Disable(GL_ARK);
      t.expect_same_picture(refined, picture_of(draw), program == programs[0] ? "the first program" : "the second", 2,
                            20);
      gl.Enable(GL_ARK);
    }
  }
  t.expect_no_error("the draws");
}

// Vertices of a list get their tags by the generic attribute, or by an array that is enabled only while it is compiled.
void check_tags(Test& t, bool is_array) {
  refine_immediate_triangles(t);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  const GLfloat places[] = {-0.5F, -0.5F, 0.5F, -0.5F, 0, 0.5F};
  const GLfloat tags[] = {2, 2, 2};
  gl.VertexAttrib1f(attribute, 0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  if (is_array) {
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, places);
    gl.VertexAttribPointer(attribute, 1, GL_FLOAT, GL_FALSE, 0, tags);
    gl.EnableVertexAttribArray(0);
    gl.EnableVertexAttribArray(attribute);
    for (GLint i = 0; i < 3; ++i) gl.ArrayElement(i);
    gl.DisableVertexAttribArray(attribute);
    gl.DisableVertexAttribArray(0);
  } else {
    gl.VertexAttrib1f(attribute, 2);
    for (int i = 0; i < 3; ++i) gl.Vertex2f(places[2 * i], places[2 * i + 1]);
  }
  gl.End();
  gl.EndList();
  for (int again = 0; again < 4; ++again) {
    gl.VertexAttrib1f(attribute, 0);
    t.expect_equal(count_generated([] { gl.CallList(1); }), 16U, "triangles of the list");
  }
}

// A called list sets another base: whichever base holds for the names after it, refinement changes nothing.
void check_changed_base(Test& t, bool is_nested) {
  gl.UseProgram(colour_program(t));
  refine_uniformly(2);
  const auto compile = [](GLuint name, int triangles, bool sets_base) {
    gl.NewList(name, GL_COMPILE);
    for (int i = 0; i < triangles; ++i) draw_immediate_triangle();
    if (sets_base) gl.ListBase(20);
    gl.EndList();
  };
  for (const GLuint base : {10U, 20U}) {
    compile(base, 0, base == 10);
    compile(base + 1, static_cast<int>(base) / 10, false);
    compile(base + 2, static_cast<int>(base) / 5, base == 10);
  }
  const GLubyte names[] = {1, 0, 1, 2, 1};
  const auto call_names = [&names] { gl.CallLists(5, GL_UNSIGNED_BYTE, names); };
  gl.NewList(1, GL_COMPILE);
  call_names();
  call_names();
  gl.EndList();
  const auto draw = [&] {
    gl.ListBase(10);
    is_nested ? gl.CallList(1) : call_names();
  };
  gl.Disable(GL_ARK);
  const GLuint plain = count_generated(draw);
  const GLint base_after = integer_of(GL_LIST_BASE);
  gl.Enable(GL_ARK);
  for (int again = 0; again < 3; ++again) {
    t.expect_equal(count_generated(draw), 16 * plain, "triangles");
    t.expect_equal(integer_of(GL_LIST_BASE), base_after, "the base afterwards");
  }
  gl.ListBase(10);
  gl.NewList(2, GL_COMPILE_AND_EXECUTE);
  const GLuint executed = count_generated(call_names);
  gl.EndList();
  gl.ListBase(10);
  t.expect_equal(executed, count_generated(call_names), "triangles of a list that is compiled and executed");
  t.expect_no_error("the calls");
}

constexpr Area called_case{.prefix = "ark.list.called.", .apis = compat_only};

}  // namespace

Cases called_lists_cases() {
  const char* const wrong = "The uniform of another program, or an earlier value.";
  return {called_case("names", {"10.R.2-1", "chapter-21-4"}, "CallLists with names of all types, also below zero.",
                      "Another list, or none.", check_negative_names),
          called_case("changed_base", {"10.R.2-2", "chapter-21-4"}, "CallLists of a list that sets ListBase.",
                      "The names that follow are counted from another base than without refinement.",
                      [](Test& t) { check_changed_base(t, false); }),
          called_case("changed_base_within", {"10.R.2-2", "chapter-21-4"}, "The same, called by a list.",
                      "The names that follow are counted from another base than without refinement.",
                      [](Test& t) { check_changed_base(t, true); }),
          called_case("program_then_uniform", {"11.R.10-1", "chapter-21-4"},
                      "A list uses another program. Then its uniform is set.", wrong,
                      [](Test& t) { check_programs(t, Kind::uniform_after); }),
          called_case("program_uniform", {"11.R.10-1", "chapter-21-4"},
                      "A list sets a uniform of a program that is not in use.", wrong,
                      [](Test& t) { check_programs(t, Kind::program_uniform); }),
          called_case("programs_within", {"11.R.10-1", "chapter-21-4"},
                      "A list uses another program, sets its uniform, and uses the first program again.", wrong,
                      [](Test& t) { check_programs(t, Kind::both_within); }),
          called_case("tag_attribute", {"10.R.1-2", "chapter-21-4"},
                      "A list sets the attribute of the tags between Begin and End.", "The tag from outside the list.",
                      [](Test& t) { check_tags(t, false); }),
          called_case("tag_element", {"10.R.1-2", "chapter-21-4"}, "A list has the vertices and tags of ArrayElement.",
                      "The tag from outside the list.", [](Test& t) { check_tags(t, true); })};
}

}  // namespace glark::conformance
