// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Errors of drawing commands and capabilities, and of every command between Begin and End ("Errors").
#include <limits>

#include "conformance/cases/cases.h"
#include "conformance/cases/triangle_modes.h"
#include "conformance/support/capture.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

struct Mode {
  const char* leaf;
  GLenum mode;
};

constexpr Mode other_modes[] = {
    {"points", GL_POINTS},
    {"lines", GL_LINES},
    {"line_strip", GL_LINE_STRIP},
    {"line_loop", GL_LINE_LOOP},
    {"lines_adjacency", GL_LINES_ADJACENCY},
    {"line_strip_adjacency", GL_LINE_STRIP_ADJACENCY},
    {"triangles_adjacency", GL_TRIANGLES_ADJACENCY},
    {"triangle_strip_adjacency", GL_TRIANGLE_STRIP_ADJACENCY},
    {"patches", GL_PATCHES},
    {"no_mode", 0x6F00},
    {"great", 0xFFFFFFFFU},
};

void set_up_draw(Test& t) {
  gl.UseProgram(colour_program(t));
  const GLushort indices[] = {0, 1, 2, 0};
  GLuint buffer = 0;
  upload(one_triangle());
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  clear_surface();
}

// Expects no error, no change of state, and no pixel.
void expect_no_draw(Test& t, GLenum error, const std::string& what, const std::function<void()>& draw) {
  const Picture before = read_picture(surface_size, surface_size);
  expect_refused(t, error, what, draw);
  t.expect_same_picture(read_picture(surface_size, surface_size), before, what + ": nothing is drawn");
}

void check_mode(Test& t, GLenum mode) {
  set_up_draw(t);
  for (const bool is_enabled : {false, true}) {
    gl.ARKinit(2);
    if (is_enabled) gl.Enable(GL_ARK);
    expect_no_draw(t, GL_INVALID_ENUM, "DrawARP", [&] { gl.DrawARP(mode, 0, 3); });
    expect_no_draw(t, GL_INVALID_ENUM, "DrawARPElementsARK",
                   [&] { gl.DrawARPElementsARK(mode, 3, GL_UNSIGNED_SHORT, nullptr); });
  }
}

Case refused_mode(const std::string& leaf, GLenum mode, bool is_compat_only) {
  std::vector<std::string> clauses{"errors-15"};
  if (is_compat_only) clauses.emplace_back("core-2");
  Case result{.name = "ark.error.draw.mode." + leaf,
              .clauses = std::move(clauses),
              .plan = "Call DrawARP and DrawARPElementsARK with this mode: INVALID_ENUM, and nothing is drawn.",
              .wrong = "Drawn unrefined, as by DrawArrays.",
              .check = [mode](Test& t) { check_mode(t, mode); }};
  if (is_compat_only) result.apis = {Api::gl_core, Api::gles};
  return result;
}

void check_draw_before_init(Test& t, GLenum mode) {
  set_up_draw(t);
  expect_no_draw(t, GL_INVALID_OPERATION, "DrawARP", [&] { gl.DrawARP(mode, 0, 3); });
  expect_no_draw(t, GL_INVALID_OPERATION, "DrawARPElementsARK",
                 [&] { gl.DrawARPElementsARK(mode, 3, GL_UNSIGNED_SHORT, nullptr); });
  gl.ARKinit(0xFFFF);
  t.expect_error(GL_INVALID_VALUE, "an ARKinit that fails");
  expect_no_draw(t, GL_INVALID_OPERATION, "DrawARP afterwards", [&] { gl.DrawARP(mode, 0, 3); });
  gl.ARKinit(0);
  gl.DrawARP(mode, 0, 3);
  gl.DrawARPElementsARK(mode, 3, GL_UNSIGNED_SHORT, nullptr);
  t.expect_no_error("with a pool of level 0");
  t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_FALSE}, "IsEnabled(ARK)");
}

Case draw_before_init(const TriangleMode& mode) {
  Case result{.name = std::string("ark.error.draw.before_init.") + mode.name,
              .clauses = {"errors-16"},
              .plan = "Call DrawARP and DrawARPElementsARK before ARKinit, and after an ARKinit that failed.",
              .wrong = "Drawn unrefined.",
              .check = [mode](Test& t) { check_draw_before_init(t, mode.mode); }};
  if (mode.is_legacy) result.apis = compat_only;
  return result;
}

void check_counts(Test& t) {
  set_up_draw(t);
  gl.ARKinit(2);
  constexpr GLint lowest = std::numeric_limits<GLint>::min();
  for (const GLint negative : {-1, lowest}) {
    expect_no_draw(t, GL_INVALID_VALUE, "DrawARP with a negative first",
                   [&] { gl.DrawARP(GL_TRIANGLES, negative, 3); });
    expect_no_draw(t, GL_INVALID_VALUE, "DrawARP with a negative count",
                   [&] { gl.DrawARP(GL_TRIANGLES, 0, negative); });
    expect_no_draw(t, GL_INVALID_VALUE, "DrawARPElementsARK with a negative count",
                   [&] { gl.DrawARPElementsARK(GL_TRIANGLES, negative, GL_UNSIGNED_SHORT, nullptr); });
  }
  for (const GLsizei count : {0, 1, 2}) {
    gl.DrawARP(GL_TRIANGLES, 0, count);
    gl.DrawARPElementsARK(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, nullptr);
    t.expect_no_error("less than a triangle");
  }
}

void check_index_types(Test& t) {
  set_up_draw(t);
  gl.ARKinit(2);
  for (const int type : {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE, 0, GL_HALF_FLOAT, GL_UNSIGNED_INT + 1})
    expect_no_draw(t, GL_INVALID_ENUM, "index type " + as_text(type),
                   [&] { gl.DrawARPElementsARK(GL_TRIANGLES, 3, static_cast<GLenum>(type), nullptr); });
}

void check_compiling(Test& t) {
  set_up_draw(t);
  gl.ARKinit(2);
  for (const GLenum how : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, how);
    gl.DrawARP(GL_TRIANGLES, 0, 3);
    t.expect_error(GL_INVALID_OPERATION, "DrawARP in a list");
    gl.DrawARPElementsARK(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr);
    t.expect_error(GL_INVALID_OPERATION, "DrawARPElementsARK in a list");
    gl.EndList();
    const Picture before = read_picture(surface_size, surface_size);
    gl.CallList(list);
    t.expect_no_error("the call of the list");
    t.expect_same_picture(read_picture(surface_size, surface_size), before, "the list is empty");
  }
}

void check_indexed_capabilities(Test& t) {
  set_everything(t);
  for (const GLenum name : {GL_ARK, GL_DEPTH_TAG_ARRAY_ARK})
    for (const GLuint index : {0U, 3U}) {
      expect_refused(t, GL_INVALID_ENUM, "Enablei", [&] { gl.Enablei(name, index); });
      expect_refused(t, GL_INVALID_ENUM, "Disablei", [&] { gl.Disablei(name, index); });
      expect_refused(t, GL_INVALID_ENUM, "IsEnabledi",
                     [&] { t.expect_equal(int{gl.IsEnabledi(name, index)}, int{GL_FALSE}, "IsEnabledi returns"); });
    }
}

struct Command {
  const char* leaf;
  const char* clause;
  std::function<void(Test&)> call;
};

void get_nothing(Test& t, GLuint program) {
  GLint value = -7;
  gl.GetRefinementivARK(program, GL_REFINEMENT_SOURCE_LENGTH_ARK, &value);
  t.expect_equal(value, -7, "GetRefinementivARK left the value alone");
}

void get_no_log(Test& t) {
  GLsizei length = -7;
  char log[4] = {'a', 'b', 'c', 0};
  gl.GetRefinementInfoLogARK(0, sizeof(log), &length, log);
  t.expect(length == -7 && log[0] == 'a', "GetRefinementInfoLogARK leaves both alone");
}

const std::vector<Command>& commands() {
  static const char* const source = "void refine() {}";
  static const std::vector<Command> all{
      {"init", "errors-1", [](Test&) { gl.ARKinit(1); }},
      {"init_too_great", "errors-1", [](Test&) { gl.ARKinit(100); }},
      {"parameteri", "errors-1", [](Test&) { gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK); }},
      {"parameterf", "errors-1", [](Test&) { gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 5); }},
      {"tag_pointer", "errors-1", [](Test&) { gl.DepthTagPointerARK(GL_FLOAT, 16, nullptr); }},
      {"tag_pointer_type", "errors-1", [](Test&) { gl.DepthTagPointerARK(GL_BYTE, -4, nullptr); }},
      {"draw", "errors-1", [](Test&) { gl.DrawARP(GL_TRIANGLES, 0, 3); }},
      {"draw_elements", "errors-1", [](Test&) { gl.DrawARPElementsARK(GL_TRIANGLES, 0, GL_UNSIGNED_SHORT, nullptr); }},
      {"shader_source", "errors-1", [](Test&) { gl.RefinementShaderSourceARK(0, 1, &source, nullptr); }},
      {"get_refinement", "errors-1", [](Test& t) { get_nothing(t, 0); }},
      {"get_log", "errors-1", get_no_log},
      {"enable", "errors-1", [](Test&) { gl.Enable(GL_ARK); }},
      {"disable", "11.R.1-12", [](Test&) { gl.Disable(GL_ARK); }},
      {"enable_array", "10.R.1-26", [](Test&) { gl.Disable(GL_DEPTH_TAG_ARRAY_ARK); }},
      {"is_enabled", "11.R.1-12",
       [](Test& t) { t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_FALSE}, "IsEnabled"); }},
      {"get_integer", "tokens-14",
       [](Test& t) { t.expect_equal(integer_of(GL_POOL_LEVEL_ARK), -77777, "GetIntegerv left the value alone"); }},
  };
  return all;
}

Picture draw_with(const std::function<void()>& between) {
  clear_surface();
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, 0, 0);
  gl.Vertex2f(-0.75F, -0.5F);
  gl.Color3f(0, 1, 0);
  gl.Vertex2f(0.5F, -0.75F);
  between();
  gl.Vertex2f(0.25F, 0.75F);
  gl.End();
  return read_picture(surface_size, surface_size);
}

void check_begin_end(Test& t, const Command& command) {
  const Picture expected = draw_with([] {});
  set_everything(t);
  gl.Disable(GL_ARK);
  gl.BindVertexArray(0);
  const Snapshot before = take_snapshot(t);
  const Picture actual = draw_with([&] { command.call(t); });
  t.expect_error(GL_INVALID_OPERATION, command.leaf);
  t.expect_no_error("one error only");
  expect_unchanged(t, take_snapshot(t), before, command.leaf);
  t.expect_same_picture(actual, expected, "the primitive that was begun");
}

void check_tag_between(Test& t) {
  const Picture expected = draw_with([] {});
  gl.ARKinit(3);
  const Picture actual = draw_with([] { gl.DepthTag1i(2); });
  t.expect_no_error("DepthTag1i between Begin and End");
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "the tag");
  t.expect_same_picture(actual, expected, "the primitive that was begun");
  draw_with([] { gl.DepthTag1i(4); });
  t.expect_error(GL_INVALID_VALUE, "a tag above the level between Begin and End");
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "the tag afterwards");
}

void draw_triangle() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// Earlier errors are neither lost nor blamed on the draw.
void check_pending(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  clear_surface();
  gl.Enable(0x1234);
  refine_uniformly(2);
  draw_triangle();
  t.expect_error(GL_INVALID_ENUM, "the earlier error, after the first refined draw");
  t.expect_no_error("no other error");
  const Picture first = read_picture(surface_size, surface_size);
  t.expect(count_different(first, Picture(surface_size, surface_size), 8) > 1000,
           "the triangle is drawn in spite of the error");
  for (int again = 0; again < 4; ++again) {
    clear_surface();
    gl.LineWidth(-1);
    draw_triangle();
    t.expect_error(GL_INVALID_VALUE, "the earlier error, after a repeated draw");
    t.expect_no_error("no other error");
    t.expect_same_picture(read_picture(surface_size, surface_size), first, "the repeated draw");
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, -1);
    gl.ARKinit(3);
    t.expect_error(GL_INVALID_VALUE, "the earlier error, after ARKinit");
    t.expect_no_error("no other error");
  }
}

}  // namespace

Cases errors_cases() {
  Cases cases{
      {.name = "ark.error.draw.counts",
       .clauses = {"errors-17", "errors-2"},
       .plan = "Pass a negative first and count; counts below 3 are no error.",
       .wrong = "A negative first is passed on, and the draw reads before the buffer.",
       .check = check_counts},
      {.name = "ark.error.draw.index_types",
       .clauses = {"errors-18"},
       .plan = "Call DrawARPElementsARK with types that are not index types.",
       .wrong = "Signed integers count as unsigned ones.",
       .check = check_index_types},
      {.name = "ark.error.draw.compiling",
       .clauses = {"errors-16"},
       .plan = "Call DrawARP and DrawARPElementsARK while a list is compiled, also with COMPILE_AND_EXECUTE.",
       .wrong = "The draw is compiled; or it is executed at once.",
       .apis = compat_only,
       .check = check_compiling},
      {.name = "ark.error.indexed_capability",
       .clauses = {"errors-6", "tokens-1", "tokens-10"},
       .plan = "Call Enablei, Disablei and IsEnabledi for both capabilities, also with index 0.",
       .wrong = "Index 0 counts as Enable.",
       .check = check_indexed_capabilities},
      {.name = "ark.error.pending",
       .clauses = {"10.R.2-13", "errors-2"},
       .plan = "An error is pending before a refined draw: afterwards it is pending once.",
       .wrong = "The error is lost, doubled, or blamed on the draw, which then draws nothing.",
       .check = check_pending},
      {.name = "ark.error.begin_end.depth_tag",
       .clauses = {"errors-1", "errors-11", "10.R.1-13"},
       .plan = "DepthTag1i between Begin and End is no error, except for a tag above the level.",
       .wrong = "INVALID_OPERATION; the vertices are lost.",
       .apis = compat_only,
       .check = check_tag_between},
  };
  for (const Mode& mode : other_modes) cases.push_back(refused_mode(mode.leaf, mode.mode, false));
  for (const TriangleMode& mode : triangle_modes) {
    if (mode.is_legacy) cases.push_back(refused_mode(mode.name, mode.mode, true));
    cases.push_back(draw_before_init(mode));
  }
  for (const Command& command : commands())
    cases.push_back({.name = std::string("ark.error.begin_end.") + command.leaf,
                     .clauses = {command.clause, "errors-2"},
                     .plan = "Call the command between two vertices of a triangle: INVALID_OPERATION, nothing is "
                             "written, no state changes, and the triangle is drawn.",
                     .wrong = "The command is executed; another error comes first; the triangle is lost.",
                     .apis = compat_only,
                     .check = [command](Test& t) { check_begin_end(t, command); }});
  return cases;
}

}  // namespace glark::conformance
