// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists (chapter 21).
#include <map>

#include "conformance/cases/cases.h"
#include "conformance/cases/lists/immediate_triangle.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

GLuint compile(const std::function<void()>& commands, GLenum mode = GL_COMPILE) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, mode);
  commands();
  gl.EndList();
  return list;
}

std::size_t triangles_of_list(Test& t, GLuint list) {
  return triangles_of(t, [&] { gl.CallList(list); });
}

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 1U, "triangles between Begin and End");
  t.expect_equal(triangles_of_list(t, compile(draw_immediate_triangle)), 1U, "triangles of a list");
}

void check_tag_compiled(Test& t) {
  refine_immediate_triangles(t);
  gl.DepthTag1i(1);
  const GLuint list = compile([] { gl.DepthTag1i(3); });
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 1, "the tag while DepthTag1i was only compiled");
  gl.CallList(list);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "the tag after the call");
  gl.DepthTag1i(0);
  compile([] { gl.DepthTag1i(2); }, GL_COMPILE_AND_EXECUTE);
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "the tag after COMPILE_AND_EXECUTE");
  t.expect_no_error("the lists");
}

void check_tags_of_list(Test& t) {
  refine_immediate_triangles(t);
  const GLuint with = compile([] {
    gl.DepthTag1i(2);
    draw_immediate_triangle();
    gl.DepthTag1i(1);
    draw_immediate_triangle();
  });
  gl.DepthTag1i(4);
  for (const GLuint tag : {4U, 0U}) {
    gl.DepthTag1i(tag);
    t.expect_equal(triangles_of_list(t, with), 16U + 4U, "triangles of a list with tags");
  }
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 1, "the tag that the list leaves");
  const GLuint without = compile(draw_immediate_triangle);
  for (const GLuint tag : {3U, 0U, 2U}) {
    gl.DepthTag1i(tag);
    t.expect_equal(triangles_of_list(t, without), std::size_t{1} << (2 * tag), "triangles of a list without tags");
  }
}

void check_tags_within(Test& t) {
  refine_immediate_triangles(t);
  gl.DepthTag1i(0);
  const GLuint list = compile([] {
    gl.Begin(GL_TRIANGLES);
    gl.DepthTag1i(4);
    gl.VertexAttrib4f(0, -0.5F, -0.5F, 0, 1);
    gl.DepthTag1i(1);
    gl.VertexAttrib4f(0, 0.5F, -0.5F, 0, 1);
    gl.DepthTag1i(2);
    gl.VertexAttrib4f(0, 0, 0.5F, 0, 1);
    gl.End();
  });
  t.expect_equal(triangles_of_list(t, list), 12U, "triangles with the edge depths 2, 1 and 3");
  t.expect_equal(triangles_of_list(t, list), 12U, "triangles of the second call");
}

void check_state_of_call(Test& t) {
  refine_immediate_triangles(t);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  const GLuint list = compile(draw_immediate_triangle);
  t.expect_equal(triangles_of_list(t, list), 4U, "triangles at the level of the compilation");
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  t.expect_equal(triangles_of_list(t, list), 64U, "triangles at another level");
  gl.Disable(GL_ARK);
  t.expect_equal(triangles_of_list(t, list), 1U, "triangles while disabled");
  const GLuint other = compile(draw_immediate_triangle);
  gl.Enable(GL_ARK);
  t.expect_equal(triangles_of_list(t, other), 64U, "triangles of a list that was compiled while disabled");
  gl.ARKinit(2);
  t.expect_equal(triangles_of_list(t, other), 16U, "triangles with a smaller pool");
}

void check_shader_of_call(Test& t) {
  const GLuint program = capture_program(t);
  gl.UseProgram(program);
  refine_uniformly(1);
  set_refinement_shader(t, program, "void refine() { position.z = 0.25; }");
  const GLuint list = compile(draw_immediate_triangle);
  const auto expect_z = [&](float z, const std::string& what) {
    for (const CapturedVertex& vertex : capture(t, [&] { gl.CallList(list); }))
      t.expect_equal(vertex.position[2], z, what);
  };
  expect_z(0.25F, "the refinement shader of the compilation");
  set_refinement_shader(t, program, "void refine() { position.z = 0.5; }");
  expect_z(0.5F, "another refinement shader");
  gl.RefinementShaderSourceARK(program, 0, nullptr, nullptr);
  expect_z(0, "none");
}

struct Immediate {
  const char* leaf;
  std::function<void(Test&)> command;
  std::map<std::string, std::string> changes;  // of entries of the snapshot
};

void check_queries_answer(Test& t) {
  t.expect_equal(integer_of(GL_POOL_LEVEL_ARK), 5, "GetIntegerv in a list");
  t.expect_equal(int{gl.IsEnabled(GL_ARK)}, int{GL_TRUE}, "IsEnabled in a list");
  GLint length = -7;
  gl.GetRefinementivARK(0, GL_REFINEMENT_SOURCE_LENGTH_ARK, &length);
  t.expect_equal(length, 0, "GetRefinementivARK in a list");
  char log[8] = "abc";
  gl.GetRefinementInfoLogARK(0, sizeof(log), nullptr, log);
  t.expect_equal(std::string(log), std::string(), "GetRefinementInfoLogARK in a list");
}

const std::vector<Immediate>& immediates() {
  static const char* const source = "void refine() { }";
  static const std::vector<Immediate> all{
      {"disable", [](Test&) { gl.Disable(GL_ARK); }, {{"ark", "0"}, {"IsEnabled(ARK)", "false"}}},
      {"enable", [](Test&) { gl.Enable(GL_ARK); }, {}},
      {"disable_array",
       [](Test&) { gl.Disable(GL_DEPTH_TAG_ARRAY_ARK); },
       {{"depth_tag_array", "0"}, {"IsEnabled(DEPTH_TAG_ARRAY_ARK)", "false"}}},
      {"disable_client_state",
       [](Test&) { gl.DisableClientState(GL_DEPTH_TAG_ARRAY_ARK); },
       {{"depth_tag_array", "0"}, {"IsEnabled(DEPTH_TAG_ARRAY_ARK)", "false"}}},
      {"enable_client_state", [](Test&) { gl.EnableClientState(GL_DEPTH_TAG_ARRAY_ARK); }, {}},
      {"init", [](Test&) { gl.ARKinit(8); }, {{"pool_level", "8"}}},
      {"init_lower",
       [](Test&) { gl.ARKinit(2); },
       {{"pool_level", "2"}, {"current_depth_tag", "2"}, {"uniform_depth_level", "2"}}},
      {"parameter", [](Test&) { gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 77); }, {{"edge_pixels", "77"}}},
      {"parameter_f",
       [](Test&) { gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0.25F); },
       {{"displacement_bias", "0.25"}}},
      {"number", [](Test&) { gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 7.5F); }, {{"displacement_bias", "7.5"}}},
      {"tag_pointer",
       [](Test&) { gl.DepthTagPointerARK(GL_UNSIGNED_SHORT, 10, reinterpret_cast<const void*>(std::size_t{4})); },
       {{"depth_tag_array_stride", "10"}}},
      {"shader_source", [](Test&) { gl.RefinementShaderSourceARK(0, 1, &source, nullptr); }, {{"source length", "18"}}},
      {"queries", check_queries_answer, {}},
  };
  return all;
}

// Entries of attributes follow from the other entries.
Snapshot without_attributes(Snapshot snapshot) {
  std::erase_if(snapshot, [](const auto& entry) { return entry.first.starts_with("attribute "); });
  return snapshot;
}

void check_immediate(Test& t, const Immediate& immediate) {
  const EverythingSet objects = set_everything(t);
  const Snapshot initial = take_snapshot(t);
  Snapshot expected = without_attributes(initial);
  for (const auto& [name, value] : immediate.changes) expected.at(name) = value;
  gl.NewList(gl.GenLists(1), GL_COMPILE);
  const auto list = static_cast<GLuint>(integer_of(GL_LIST_INDEX));
  immediate.command(t);
  expect_unchanged(t, take_snapshot(t), expected, "while the list is compiled");
  gl.EndList();
  t.expect_no_error("the list");
  // Restores the state by hand. The list must not change it.
  gl.ARKinit(5);
  gl.Enable(GL_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 4);
  gl.DepthTag1i(3);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 12);
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, -0.75F);
  gl.BindBuffer(GL_ARRAY_BUFFER, objects.buffer);
  gl.DepthTagPointerARK(GL_UNSIGNED_SHORT, 6, reinterpret_cast<const void*>(std::size_t{4}));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.RefinementShaderSourceARK(0, 0, nullptr, nullptr);
  gl.CallList(list);
  expect_unchanged(t, take_snapshot(t), initial, "after the call of the list");
}

void check_before_init(Test& t) {
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
  gl.UseProgram(colour_program(t));
  clear_surface();
  draw_immediate_triangle();
  const Picture expected = read_picture(surface_size, surface_size);
  const GLuint list = compile(draw_immediate_triangle);
  gl.ARKinit(2);
  gl.DepthTag1i(1);
  gl.Enable(GL_ARK);
  clear_surface();
  gl.CallList(list);
  t.expect_same_picture(read_picture(surface_size, surface_size), expected, "the list is drawn");
}

void check_before_init_captured(Test& t) {
  gl.UseProgram(capture_program(t));
  const GLuint list = compile(draw_immediate_triangle);
  gl.ARKinit(2);
  gl.DepthTag1i(1);
  gl.Enable(GL_ARK);
  const std::size_t triangles = triangles_of_list(t, list);
  t.expect(triangles == 1 || triangles == 4, "the list is drawn, refined or not: " + as_text(triangles) + " triangles");
}

constexpr Area list_case{.prefix = "ark.list.", .control = control, .apis = compat_only};
constexpr Area uncontrolled{.prefix = "ark.list.", .apis = compat_only};

}  // namespace

Cases display_lists_cases() {
  Cases cases{
      uncontrolled("tag.compiled", {"chapter-21-2", "errors-1"},
                   "Compile DepthTag1i, check the tag, and call the list; then the same with COMPILE_AND_EXECUTE.",
                   "Executed at once; not compiled.", check_tag_compiled),
      list_case("tag.draws", {"chapter-21-2", "chapter-21-5"},
                "A list with two tags and two triangles; another without tags, called with three current tags.",
                "The tag at compilation; the current tag for a list with tags.", check_tags_of_list),
      list_case("tag.vertices", {"chapter-21-2", "chapter-21-5", "10.R.1-13"},
                "A list with another tag at each vertex, called twice.", "The last tag for all vertices.",
                check_tags_within),
      list_case("state_of_call", {"chapter-21-4"},
                "Call one list at several levels and while disabled, and one that was compiled while disabled.",
                "The state at compilation.", check_state_of_call),
      list_case("shader_of_call", {"chapter-21-4"}, "Call one list with two refinement shaders and with none.",
                "The refinement shader at compilation.", check_shader_of_call),
      list_case("before_init", {"chapter-21-6"}, "Draw a list that was compiled before ARKinit, and compare pictures.",
                "Nothing is drawn.", check_before_init),
      list_case("before_init_captured", {"chapter-21-6"},
                "Capture a list that was compiled before ARKinit: it gives one triangle, or four.",
                "Nothing is captured.", check_before_init_captured),
  };
  for (const Immediate& immediate : immediates())
    cases.push_back(uncontrolled(
        std::string("immediate.") + immediate.leaf, {"chapter-21-7"},
        "Call the command while a list is compiled: it is executed. Set all state back: the list does nothing.",
        "The command is compiled, additionally or only; INVALID_OPERATION.",
        [immediate](Test& t) { check_immediate(t, immediate); }));
  return cases;
}

}  // namespace glark::conformance
