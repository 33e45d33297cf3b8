// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Display lists and attribute groups (chapters 21 and 22).
#include <map>

#include "conformance/cases/cases.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

// One triangle of immediate mode, drawn by draw() to transform feedback.
std::size_t triangles_of(Test& t, const std::function<void()>& draw) {
  const std::size_t triangles = capture(t, draw).size() / 3;
  t.expect_equal(std::size_t{count_generated(draw)}, triangles, "triangles without transform feedback");
  return triangles;
}

void triangle() {
  gl.Begin(GL_TRIANGLES);
  gl.VertexAttrib4f(0, -0.5F, -0.5F, 0, 1);
  gl.VertexAttrib4f(0, 0.5F, -0.5F, 0, 1);
  gl.VertexAttrib4f(0, 0, 0.5F, 0, 1);
  gl.End();
}

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

void set_up(Test& t, GLuint level = 4) {
  gl.UseProgram(capture_program(t));
  gl.ARKinit(level);
  gl.Enable(GL_ARK);
}

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  t.expect_equal(triangles_of(t, triangle), 1U, "triangles between Begin and End");
  t.expect_equal(triangles_of_list(t, compile(triangle)), 1U, "triangles of a list");
}

void check_tag_compiled(Test& t) {
  set_up(t);
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
  set_up(t);
  const GLuint with = compile([] {
    gl.DepthTag1i(2);
    triangle();
    gl.DepthTag1i(1);
    triangle();
  });
  gl.DepthTag1i(4);
  for (const GLuint tag : {4U, 0U}) {
    gl.DepthTag1i(tag);
    t.expect_equal(triangles_of_list(t, with), 16U + 4U, "triangles of a list with tags");
  }
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 1, "the tag that the list leaves");
  const GLuint without = compile(triangle);
  for (const GLuint tag : {3U, 0U, 2U}) {
    gl.DepthTag1i(tag);
    t.expect_equal(triangles_of_list(t, without), std::size_t{1} << (2 * tag), "triangles of a list without tags");
  }
}

void check_tags_within(Test& t) {
  set_up(t);
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
  set_up(t);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  const GLuint list = compile(triangle);
  t.expect_equal(triangles_of_list(t, list), 4U, "triangles at the level of the compilation");
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 3);
  t.expect_equal(triangles_of_list(t, list), 64U, "triangles at another level");
  gl.Disable(GL_ARK);
  t.expect_equal(triangles_of_list(t, list), 1U, "triangles while disabled");
  const GLuint other = compile(triangle);
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
  const GLuint list = compile(triangle);
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
  std::map<std::string, std::string> changes;  // of the snapshot
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

// The attributes' own entries follow from these.
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
  // Set back by hand, the list changes nothing.
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
  triangle();
  const Picture expected = read_picture(surface_size, surface_size);
  const GLuint list = compile(triangle);
  gl.ARKinit(2);
  gl.DepthTag1i(1);
  gl.Enable(GL_ARK);
  clear_surface();
  gl.CallList(list);
  t.expect_same_picture(read_picture(surface_size, surface_size), expected, "the list is drawn");
}

void check_before_init_captured(Test& t) {
  gl.UseProgram(capture_program(t));
  const GLuint list = compile(triangle);
  gl.ARKinit(2);
  gl.DepthTag1i(1);
  gl.Enable(GL_ARK);
  const std::size_t triangles = triangles_of_list(t, list);
  t.expect(triangles == 1 || triangles == 4, "the list is drawn, refined or not: " + as_text(triangles) + " triangles");
}

// PushAttrib and PopAttrib.
void check_enable_group(Test& t) {
  set_everything(t);
  for (const bool is_enabled : {true, false}) {
    (is_enabled ? gl.Enable : gl.Disable)(GL_ARK);
    for (const GLbitfield mask : {GLbitfield{GL_ENABLE_BIT}, GLbitfield{GL_ALL_ATTRIB_BITS}}) {
      const Snapshot before = take_snapshot(t);
      gl.PushAttrib(mask);
      t.expect_equal(gl.IsEnabled(GL_ARK) == GL_TRUE, is_enabled, "after PushAttrib");
      (is_enabled ? gl.Disable : gl.Enable)(GL_ARK);
      gl.PushAttrib(mask);
      (is_enabled ? gl.Enable : gl.Disable)(GL_ARK);
      gl.PopAttrib();
      t.expect_equal(gl.IsEnabled(GL_ARK) == GL_TRUE, !is_enabled, "after the inner PopAttrib");
      gl.PopAttrib();
      expect_unchanged(t, take_snapshot(t), before, "after the outer PopAttrib");
    }
    gl.PushAttrib(GL_CURRENT_BIT | GL_TRANSFORM_BIT);
    (is_enabled ? gl.Disable : gl.Enable)(GL_ARK);
    gl.PopAttrib();
    t.expect_equal(gl.IsEnabled(GL_ARK) == GL_TRUE, !is_enabled, "another group does not restore it");
  }
}

void check_enable_group_draws(Test& t) {
  set_up(t);
  gl.DepthTag1i(2);
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.Disable(GL_ARK);
  t.expect_equal(triangles_of(t, triangle), 1U, "triangles while disabled");
  gl.PopAttrib();
  t.expect_equal(triangles_of(t, triangle), 16U, "triangles after PopAttrib");
}

void check_current_group(Test& t) {
  set_up(t);
  gl.DepthTag1i(3);
  gl.PushAttrib(GL_CURRENT_BIT);
  gl.DepthTag1i(1);
  t.expect_equal(triangles_of(t, triangle), 4U, "triangles with the tag 1");
  gl.PopAttrib();
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "the tag after PopAttrib");
  t.expect_equal(triangles_of(t, triangle), 64U, "triangles after PopAttrib");
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.DepthTag1i(2);
  gl.PopAttrib();
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "another group does not restore it");
}

// No query in between: what the draws go by.
void check_current_group_draws(Test& t) {
  set_up(t);
  upload(one_triangle(), false);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  for (const GLbitfield mask : {GLbitfield{GL_CURRENT_BIT}, GLbitfield{GL_ALL_ATTRIB_BITS}}) {
    gl.DepthTag1i(3);
    gl.PushAttrib(mask);
    gl.DepthTag1i(1);
    t.expect_equal(count_generated(draw), 4U, "triangles with the tag 1");
    gl.PopAttrib();
    t.expect_equal(count_generated(draw), 64U, "triangles after PopAttrib");
    t.expect_equal(triangles_of(t, draw), 64U, "triangles after PopAttrib, captured");
  }
}

void check_client_group(Test& t) {
  set_everything(t);
  const Snapshot before = take_snapshot(t);
  gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.DepthTagPointerARK(GL_FLOAT, 24, reinterpret_cast<const void*>(std::size_t{8}));
  gl.PopClientAttrib();
  expect_unchanged(t, take_snapshot(t), before, "after PopClientAttrib");
  gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.PopClientAttrib();
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_FALSE}, "another group does not restore it");
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.PopAttrib();
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_TRUE}, "nor does a group of the server");
}

// Three times the triangle, by an array of tags and by another, or none, in between.
void check_client_group_draws(Test& t) {
  set_up(t);
  upload(one_triangle({2, 2, 2}));
  const GLubyte other_tags[] = {3, 3, 3};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(other_tags), other_tags, GL_STATIC_DRAW);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  gl.DepthTag1i(1);
  for (const bool is_disabled : {true, false}) {
    t.expect_equal(triangles_of(t, draw), 16U, "triangles with the array");
    gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    if (is_disabled)
      gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
    else
      gl.DepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
    t.expect_equal(triangles_of(t, draw), is_disabled ? 4U : 64U, "triangles in between");
    gl.PopClientAttrib();
    t.expect_equal(triangles_of(t, draw), 16U, "triangles after PopClientAttrib");
  }
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect_equal(triangles_of(t, draw), 4U, "triangles without the array");
  gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.PopClientAttrib();
  t.expect_equal(triangles_of(t, draw), 4U, "triangles after the array was enabled in between");
}

void check_no_group(Test& t) {
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.PushClientAttrib(static_cast<GLbitfield>(GL_CLIENT_ALL_ATTRIB_BITS));
  const EverythingSet objects = set_everything(t);
  const Snapshot expected = take_snapshot(t);
  gl.PopClientAttrib();
  gl.PopAttrib();
  gl.BindVertexArray(objects.array);
  Snapshot actual = take_snapshot(t);
  for (const StateName& state : extension_state()) {
    const bool is_of_group =
        state.name == GL_ARK || state.name == GL_CURRENT_DEPTH_TAG_ARK ||
        (state.name >= GL_DEPTH_TAG_ARRAY_ARK && state.name <= GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK);
    if (!is_of_group) t.expect_equal(actual.at(state.leaf), expected.at(state.leaf), state.leaf);
  }
}

Case of_compat(const char* name, std::vector<std::string> clauses, const char* plan, const char* wrong,
               std::function<void(Test&)> check, bool has_control = true) {
  return {.name = name,
          .clauses = std::move(clauses),
          .plan = plan,
          .wrong = wrong,
          .apis = compat_only,
          .control = has_control ? control : std::function<void(Test&)>(),
          .check = std::move(check)};
}

}  // namespace

Cases display_lists_cases() {
  Cases cases{
      of_compat("ark.list.tag.compiled", {"chapter-21-2", "errors-1"},
                "Compile DepthTag1i, look at the tag, and call the list; then COMPILE_AND_EXECUTE.",
                "Executed at once; not compiled.", check_tag_compiled, false),
      of_compat("ark.list.tag.draws", {"chapter-21-2", "chapter-21-5"},
                "A list with two tags and two triangles; one without tags, called with three current tags.",
                "The tag of the compilation; the current tag for a list with tags.", check_tags_of_list),
      of_compat("ark.list.tag.vertices", {"chapter-21-2", "chapter-21-5", "10.R.1-13"},
                "A list with another tag at each vertex, called twice.", "The last tag for all vertices.",
                check_tags_within),
      of_compat("ark.list.state_of_call", {"chapter-21-4"},
                "Call one list at several levels and while disabled, one that was compiled while disabled.",
                "The state of the compilation.", check_state_of_call),
      of_compat("ark.list.shader_of_call", {"chapter-21-4"}, "Call one list with two refinement shaders and with none.",
                "The refinement shader of the compilation.", check_shader_of_call),
      of_compat("ark.list.before_init", {"chapter-21-6"},
                "Draw a list that was compiled before ARKinit, and compare pictures.", "Nothing is drawn.",
                check_before_init),
      of_compat("ark.list.before_init_captured", {"chapter-21-6"},
                "Capture a list that was compiled before ARKinit: one triangle, or four.", "Nothing is captured.",
                check_before_init_captured),
      of_compat("ark.group.enable", {"chapter-22-1"},
                "PushAttrib and PopAttrib of ENABLE_BIT, nested, for both values.",
                "Not saved; always restored; other state is.", check_enable_group, false),
      of_compat("ark.group.enable_draws", {"chapter-22-1"}, "Draw before and after PopAttrib.",
                "IsEnabled is right, draws are not.", check_enable_group_draws),
      of_compat("ark.group.current", {"chapter-22-2"}, "PushAttrib and PopAttrib of CURRENT_BIT, and draws.",
                "A copy of the tag beside the attribute is not restored.", check_current_group),
      of_compat("ark.group.current_draws", {"chapter-22-2"}, "Draw with two tags, one of them within PushAttrib.",
                "The query answers right, draws have the tag of before.", check_current_group_draws),
      of_compat("ark.group.client", {"chapter-22-3"}, "PushClientAttrib and PopClientAttrib of the array.",
                "A copy of the array's state is not restored.", check_client_group, false),
      of_compat(
          "ark.group.client_draws", {"chapter-22-3"},
          "Draw with the array before PushClientAttrib, with another or none in between, and after PopClientAttrib.",
          "The state is right, draws are not.", check_client_group_draws),
      of_compat("ark.group.none", {"chapter-22-4"}, "Push all groups, set every parameter, and pop.",
                "Parameters are restored.", check_no_group, false),
  };
  for (const Immediate& immediate : immediates())
    cases.push_back(of_compat((std::string("ark.list.immediate.") + immediate.leaf).c_str(), {"chapter-21-7"},
                              "Call it while a list is compiled: it is executed. Set all back; the list does nothing.",
                              "Compiled, too, or only; INVALID_OPERATION.",
                              [immediate](Test& t) { check_immediate(t, immediate); }, false));
  return cases;
}

}  // namespace glark::conformance
