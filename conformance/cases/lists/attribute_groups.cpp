// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Attribute groups of PushAttrib and PushClientAttrib (chapter 22).
#include <fmt/core.h>
#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/cases/lists/immediate_triangle.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

void control(Test& t) {
  gl.UseProgram(capture_program(t));
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 1U, "triangles between Begin and End");
}

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
  refine_immediate_triangles(t);
  gl.DepthTag1i(2);
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.Disable(GL_ARK);
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 1U, "triangles while disabled");
  gl.PopAttrib();
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 16U, "triangles after PopAttrib");
}

// A PushAttrib that generates an error leaves nothing on the stack.
void check_enable_group_overflow(Test& t) {
  gl.ARKinit(2);
  const GLint depth = integer_of(GL_MAX_ATTRIB_STACK_DEPTH);
  const auto is_enabled_at = [](GLint i) { return i % 3 == 0; };
  for (GLint i = 0; i <= depth; ++i) {
    (is_enabled_at(i) ? gl.Enable : gl.Disable)(GL_ARK);
    gl.PushAttrib(GL_ENABLE_BIT);
  }
  t.expect_error(GL_STACK_OVERFLOW, "PushAttrib once more than MAX_ATTRIB_STACK_DEPTH");
  for (GLint i = depth; i-- > 0;) {
    gl.PopAttrib();
    t.expect_equal(gl.IsEnabled(GL_ARK) == GL_TRUE, is_enabled_at(i), fmt::format("after PopAttrib to depth {}", i));
  }
}

void check_current_group(Test& t) {
  refine_immediate_triangles(t);
  gl.DepthTag1i(3);
  gl.PushAttrib(GL_CURRENT_BIT);
  gl.DepthTag1i(1);
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 4U, "triangles with the tag 1");
  gl.PopAttrib();
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 3, "the tag after PopAttrib");
  t.expect_equal(triangles_of(t, draw_immediate_triangle), 64U, "triangles after PopAttrib");
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.DepthTag1i(2);
  gl.PopAttrib();
  t.expect_equal(integer_of(GL_CURRENT_DEPTH_TAG_ARK), 2, "another group does not restore it");
}

// Does not query the tag in between: only draws show it.
void check_current_group_draws(Test& t) {
  refine_immediate_triangles(t);
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
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_TRUE}, "nor does a server attribute group");
}

// Draws the triangle three times: with an array of tags, with another or none, and with the first again.
void check_client_group_draws(Test& t) {
  refine_immediate_triangles(t);
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

// Uploads the mesh, and sets the array of its positions; if `has_others`, also those of its colours and tags.
void point_at(const Mesh& mesh, GLuint buffer, bool has_others) {
  const auto place = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(MeshVertex)), mesh.data(),
                GL_STATIC_DRAW);
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), place(offsetof(MeshVertex, position)));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  if (!has_others) return;
  gl.ColorPointer(4, GL_FLOAT, sizeof(MeshVertex), place(offsetof(MeshVertex, colour)));
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(MeshVertex), place(offsetof(MeshVertex, tag)));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
}

// Draws with all arrays. Then the client state is the default one, and only the array of positions is set. If the first
// state was pushed, it is popped at the end.
void check_client_default(Test& t, bool is_pushed) {
  if (!t.has_extension("GL_EXT_direct_state_access")) t.not_supported("no ClientAttribDefaultEXT");
  refine_by_tags(3);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  const Mesh mesh = one_triangle({2, 2, 2});
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); };
  const auto expect_drawn = [&](GLuint triangles, const std::string& what) {
    gl.Disable(GL_ARK);
    const Picture plain = picture_of(draw);
    gl.Enable(GL_ARK);
    for (int again = 0; again < 6; ++again) t.expect_same_picture(picture_of(draw), plain, what, 3, 40);
    t.expect_equal(count_generated(draw), triangles, "triangles " + what);
  };
  point_at(mesh, buffer, true);
  gl.DepthTag1i(1);
  expect_drawn(16, "with all arrays");
  if (is_pushed)
    gl.PushClientAttribDefaultEXT(GL_CLIENT_VERTEX_ARRAY_BIT);
  else
    gl.ClientAttribDefaultEXT(GL_CLIENT_VERTEX_ARRAY_BIT);
  t.expect_equal(int{gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK)}, int{GL_FALSE}, "DEPTH_TAG_ARRAY_ARK, by default");
  t.expect_equal(integer_of(GL_ARRAY_BUFFER_BINDING), 0, "ARRAY_BUFFER_BINDING, by default");
  point_at(mesh, buffer, false);
  for (const GLfloat red : {0.0F, 0.5F, 1.0F}) {
    gl.Color3f(red, 1 - red, 0.25F);
    expect_drawn(4, "with default arrays and the current red " + as_text(red));
  }
  gl.DepthTag1i(3);
  expect_drawn(64, "with default arrays and another current tag");
  if (!is_pushed) return;
  gl.PopClientAttrib();
  expect_drawn(16, "with all arrays again");
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

constexpr Area group_case{.prefix = "ark.group.", .control = control, .apis = compat_only};
constexpr Area uncontrolled{.prefix = "ark.group.", .apis = compat_only};

}  // namespace

Cases attribute_groups_cases() {
  return {
      uncontrolled("enable", {"chapter-22-1"}, "PushAttrib and PopAttrib of ENABLE_BIT, nested, for both values.",
                   "Not saved; always restored; other state is restored too.", check_enable_group),
      group_case("enable_draws", {"chapter-22-1"}, "Draw before and after PopAttrib.",
                 "IsEnabled is right, but draws are not.", check_enable_group_draws),
      group_case("current", {"chapter-22-2"}, "PushAttrib and PopAttrib of CURRENT_BIT, and draws.",
                 "A separate copy of the tag is not restored.", check_current_group),
      group_case("current_draws", {"chapter-22-2"}, "Draw with two tags, one of them within PushAttrib.",
                 "The query is right, but draws have the earlier tag.", check_current_group_draws),
      uncontrolled("client", {"chapter-22-3"}, "PushClientAttrib and PopClientAttrib of the array.",
                   "A separate copy of the array's state is not restored.", check_client_group),
      group_case("client_draws", {"chapter-22-3"},
                 "Draw with the array before PushClientAttrib, with another array or none in between, and after "
                 "PopClientAttrib.",
                 "The state is right, but draws are not.", check_client_group_draws),
      optional(uncontrolled("client_default", {"chapter-22-3"}, "Draw with arrays, and after ClientAttribDefaultEXT.",
                            "Draws have the earlier arrays.", [](Test& t) { check_client_default(t, false); })),
      optional(uncontrolled("client_push_default", {"chapter-22-3"},
                            "Draw with arrays, after PushClientAttribDefaultEXT, and after PopClientAttrib.",
                            "Draws have the earlier arrays.", [](Test& t) { check_client_default(t, true); })),
      uncontrolled("none", {"chapter-22-4"}, "Push all groups, set every parameter, and pop.",
                   "Parameters are restored.", check_no_group),
      uncontrolled("overflow", {"chapter-22-1"},
                   "Call PushAttrib until the stack is full and once more, then PopAttrib down to the first level.",
                   "PopAttrib restores the refused state: each level has the value of the one above.",
                   check_enable_group_overflow),
  };
}

}  // namespace glark::conformance
