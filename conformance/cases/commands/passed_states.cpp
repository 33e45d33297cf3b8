// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Commands that set how fragments and primitives are drawn, in the forms that no other case calls. A refined draw looks
// like the unrefined one.
#include <array>
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct PassedState {
  const char* leaf;  // the command
  void (*set)();
  Apis apis = every_api;
};

void blend() {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void test_stencil() {
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_NOTEQUAL, 1, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

constexpr Apis gles_only = {Api::gles};
constexpr GLint left_half[] = {0, 0, surface_size / 2, surface_size};

// Each is set over blending, a stencil test and a depth test that all take part.
constexpr PassedState passed_states[] = {
    {"blend_color",
     [] {
       gl.BlendFunc(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_ALPHA);
       gl.BlendColor(0.2F, 0.9F, 0.4F, 0.7F);
     }},
    {"blend_equation_separate", [] { gl.BlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_FUNC_ADD); }},
    {"blend_equationi", [] { gl.BlendEquationi(0, GL_MAX); }},
    {"blend_equation_separatei", [] { gl.BlendEquationSeparatei(0, GL_MIN, GL_FUNC_ADD); }},
    {"blend_func_separate", [] { gl.BlendFuncSeparate(GL_ONE, GL_SRC_COLOR, GL_ONE, GL_ZERO); }},
    {"blend_funci", [] { gl.BlendFunci(0, GL_ONE, GL_ONE); }},
    {"blend_func_separatei", [] { gl.BlendFuncSeparatei(0, GL_DST_COLOR, GL_ONE, GL_ONE, GL_ONE); }},
    {"stencil_func_separate", [] { gl.StencilFuncSeparate(GL_FRONT, GL_EQUAL, 1, 0xff); }},
    {"stencil_op_separate", [] { gl.StencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR); }},
    {"stencil_mask", [] { gl.StencilMask(0xfe); }},
    {"stencil_mask_separate", [] { gl.StencilMaskSeparate(GL_FRONT, 0xfe); }},
    {"depth_range_indexed", [] { gl.DepthRangeIndexed(0, 0.9, 0.1); }, desktop_apis},
    {"depth_range_arrayv",
     [] {
       constexpr GLdouble ranges[] = {0.9, 0.1};
       gl.DepthRangeArrayv(0, 1, ranges);
     },
     desktop_apis},
    {"scissor_indexed",
     [] {
       gl.Enable(GL_SCISSOR_TEST);
       gl.ScissorIndexed(0, left_half[0], left_half[1], left_half[2], left_half[3]);
     },
     desktop_apis},
    {"scissor_indexedv",
     [] {
       gl.Enable(GL_SCISSOR_TEST);
       gl.ScissorIndexedv(0, left_half);
     },
     desktop_apis},
    {"scissor_arrayv",
     [] {
       gl.Enable(GL_SCISSOR_TEST);
       gl.ScissorArrayv(0, 1, left_half);
     },
     desktop_apis},
    {"clip_control", [] { gl.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE); }, desktop_apis},
    {"polygon_stipple",
     [] {
       std::array<GLubyte, 128> stipple{};
       stipple.fill(0x3c);
       gl.Enable(GL_POLYGON_STIPPLE);
       gl.PolygonStipple(stipple.data());
     },
     compat_only},
    {"line_stipple",
     [] {
       gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
       gl.LineStipple(3, 0x0f0f);
     },
     compat_only},
    {"point_parameterf", [] { gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 3); }, desktop_apis},
    {"point_parameteri", [] { gl.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT); }, desktop_apis},
    {"point_parameteriv",
     [] {
       constexpr GLint origin = GL_LOWER_LEFT;
       gl.PointParameteriv(GL_POINT_SPRITE_COORD_ORIGIN, &origin);
     },
     desktop_apis},
    {"patch_parameterfv",
     [] {
       constexpr GLfloat levels[] = {3, 3, 3, 3};
       gl.PatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels);
     },
     desktop_apis},
    {"index_mask", [] { gl.IndexMask(0); }, compat_only},  // of colour indices, which the surface does not have
    {"selection_names",
     [] {  // RenderMode is RENDER, so that GL ignores them
       gl.InitNames();
       gl.PushName(1);
       gl.LoadName(2);
       gl.PopName();
       gl.PassThrough(3);
     },
     compat_only},
    {"blend_barrier", [] { gl.BlendBarrier(); }, gles_only},
    {"primitive_bounding_box", [] { gl.PrimitiveBoundingBox(-1, -1, -1, 1, 1, 1, 1, 1); }, gles_only},
    {"query_counter",
     [] {
       GLuint query = 0;
       gl.CreateQueries(GL_TIMESTAMP, 1, &query);
       gl.QueryCounter(query, GL_TIMESTAMP);
     },
     desktop_apis},
    {"create_program_pipelines",
     [] {
       GLuint pipeline = 0;
       gl.CreateProgramPipelines(1, &pipeline);
       gl.BindProgramPipeline(pipeline);  // the program in use has precedence
     },
     desktop_apis},
};

// Two triangles that overlap, at different depths.
Mesh crossed_triangles() {
  Mesh mesh = one_triangle({1, 3, 2});
  for (MeshVertex vertex : one_triangle({2, 1, 3})) {
    vertex.position = {-vertex.position[0], vertex.position[1], vertex.position[0] * 0.5F, 1};
    vertex.colour[3] = 0.5F;
    mesh.push_back(vertex);
  }
  return mesh;
}

void draw_crossed() {
  gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void check_passed(Test& t, const PassedState& state) {
  if (t.version() < 45 && std::string(state.leaf) == "clip_control") t.not_supported("no ClipControl");
  gl.UseProgram(colour_program(t));
  upload(crossed_triangles());
  blend();
  test_stencil();
  gl.Enable(GL_DEPTH_TEST);
  refine_by_tags(3);
  for (int again = 0; again < 2; ++again) {
    if (again == 1) state.set();
    gl.Disable(GL_ARK);
    const Picture expected = picture_of(draw_crossed);
    gl.Enable(GL_ARK);
    t.expect_same_picture(picture_of(draw_crossed), expected, again == 0 ? "before" : state.leaf, 3, 60);
    repeat_often(draw_crossed);
    t.expect_same_picture(picture_of(draw_crossed), expected, "the same, often", 3, 60);
  }
  t.expect_no_error(state.leaf);
}

}  // namespace

Cases passed_states_cases() {
  Cases cases;
  for (const PassedState& state : passed_states)
    cases.push_back({.name = std::string("ark.rasterized.by_command.") + state.leaf,
                     .clauses = {"10.R.2-2", "11.R.13-1"},
                     .plan = "Draw often, change the state by one command, and draw again, refined and unrefined.",
                     .wrong = "A kept draw has the state of before, or the command is not passed on.",
                     .apis = state.apis,
                     .check = [&state](Test& t) { check_passed(t, state); }});
  return cases;
}

}  // namespace glark::conformance
