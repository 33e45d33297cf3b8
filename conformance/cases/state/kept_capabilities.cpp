// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A refined draw leaves each capability as it is (10.R.2-6): enabled, or disabled after it was enabled.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct Capability {
  GLenum name;
  const char* text;
  Apis apis = every_api;
};

// An implementation has to disable some of them while its own passes run.
constexpr Capability capabilities[] = {
    {GL_CULL_FACE, "CULL_FACE"},
    {GL_DEPTH_TEST, "DEPTH_TEST"},
    {GL_STENCIL_TEST, "STENCIL_TEST"},
    {GL_SCISSOR_TEST, "SCISSOR_TEST"},
    {GL_BLEND, "BLEND"},
    {GL_DITHER, "DITHER"},
    {GL_POLYGON_OFFSET_FILL, "POLYGON_OFFSET_FILL"},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, "SAMPLE_ALPHA_TO_COVERAGE"},
    {GL_SAMPLE_COVERAGE, "SAMPLE_COVERAGE"},
    {GL_SAMPLE_MASK, "SAMPLE_MASK"},
    {GL_RASTERIZER_DISCARD, "RASTERIZER_DISCARD"},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, "PRIMITIVE_RESTART_FIXED_INDEX"},
    {GL_DEBUG_OUTPUT, "DEBUG_OUTPUT"},
    {GL_DEBUG_OUTPUT_SYNCHRONOUS, "DEBUG_OUTPUT_SYNCHRONOUS"},
    {GL_PRIMITIVE_RESTART, "PRIMITIVE_RESTART", desktop_apis},
    {GL_DEPTH_CLAMP, "DEPTH_CLAMP", desktop_apis},
    {GL_COLOR_LOGIC_OP, "COLOR_LOGIC_OP", desktop_apis},
    {GL_MULTISAMPLE, "MULTISAMPLE", desktop_apis},
    {GL_LINE_SMOOTH, "LINE_SMOOTH", desktop_apis},
    {GL_POLYGON_SMOOTH, "POLYGON_SMOOTH", desktop_apis},
    {GL_POLYGON_OFFSET_LINE, "POLYGON_OFFSET_LINE", desktop_apis},
    {GL_POLYGON_OFFSET_POINT, "POLYGON_OFFSET_POINT", desktop_apis},
    {GL_PROGRAM_POINT_SIZE, "PROGRAM_POINT_SIZE", desktop_apis},
    {GL_FRAMEBUFFER_SRGB, "FRAMEBUFFER_SRGB", desktop_apis},
    {GL_CLIP_DISTANCE0, "CLIP_DISTANCE0", desktop_apis},
    {GL_CLIP_DISTANCE1, "CLIP_DISTANCE1", desktop_apis},
    {GL_CLIP_DISTANCE2, "CLIP_DISTANCE2", desktop_apis},
    {GL_CLIP_DISTANCE3, "CLIP_DISTANCE3", desktop_apis},
    {GL_CLIP_DISTANCE4, "CLIP_DISTANCE4", desktop_apis},
    {GL_CLIP_DISTANCE5, "CLIP_DISTANCE5", desktop_apis},
    {GL_CLIP_DISTANCE6, "CLIP_DISTANCE6", desktop_apis},
    {GL_CLIP_DISTANCE7, "CLIP_DISTANCE7", desktop_apis},
    {GL_LIGHTING, "LIGHTING", compat_only},
    {GL_LIGHT0, "LIGHT0", compat_only},
    {GL_LIGHT7, "LIGHT7", compat_only},
    {GL_NORMALIZE, "NORMALIZE", compat_only},
    {GL_RESCALE_NORMAL, "RESCALE_NORMAL", compat_only},
    {GL_COLOR_MATERIAL, "COLOR_MATERIAL", compat_only},
    {GL_COLOR_SUM, "COLOR_SUM", compat_only},
    {GL_VERTEX_PROGRAM_TWO_SIDE, "VERTEX_PROGRAM_TWO_SIDE", compat_only},
    {GL_FOG, "FOG", compat_only},
    {GL_TEXTURE_1D, "TEXTURE_1D", compat_only},
    {GL_TEXTURE_2D, "TEXTURE_2D", compat_only},
    {GL_TEXTURE_GEN_S, "TEXTURE_GEN_S", compat_only},
    {GL_TEXTURE_GEN_Q, "TEXTURE_GEN_Q", compat_only},
    {GL_ALPHA_TEST, "ALPHA_TEST", compat_only},
    {GL_POINT_SMOOTH, "POINT_SMOOTH", compat_only},
    {GL_POINT_SPRITE, "POINT_SPRITE", compat_only},
    {GL_LINE_STIPPLE, "LINE_STIPPLE", compat_only},
    {GL_POLYGON_STIPPLE, "POLYGON_STIPPLE", compat_only},
    {GL_AUTO_NORMAL, "AUTO_NORMAL", compat_only},
};

void draw_three() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// Writes the first position again, so that an implementation cannot use results of the draw before.
void draw_anew() {
  const Vec4 position = one_triangle()[0].position;
  gl.BufferSubData(GL_ARRAY_BUFFER, offsetof(MeshVertex, position), sizeof(position), position.data());
  draw_three();
}

void draw_often() { repeat_often(draw_three); }

using DrawsInTurn = std::vector<void (*)()>;

void expect_kept(Test& t, const Capability& capability, bool is_enabled, const DrawsInTurn& draws) {
  for (const auto draw : draws) {
    draw();
    t.expect_equal(gl.IsEnabled(capability.name) == GL_TRUE, is_enabled,
                   std::string(capability.text) + (is_enabled ? ", enabled" : ", disabled"));
  }
}

void prepare_triangle(GLenum source, bool is_fixed_function) {
  upload(one_triangle({1, 3, 2}));
  if (is_fixed_function) {
    gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), nullptr);
    gl.EnableClientState(GL_VERTEX_ARRAY);
  }
  refine_uniformly(2);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 10);
}

void expect_all_kept(Test& t, const DrawsInTurn& draws) {
  for (const Capability& capability : capabilities) {
    if (!capability.apis.contains(t.api())) continue;
    const bool was_enabled = gl.IsEnabled(capability.name) == GL_TRUE;
    gl.Enable(capability.name);
    expect_kept(t, capability, true, draws);
    gl.Disable(capability.name);
    expect_kept(t, capability, false, draws);
    if (was_enabled) gl.Enable(capability.name);
    t.expect_no_error(capability.text);
  }
}

// An implementation may keep the vertices of a draw that repeats often. Buffers must not be written in between, and no
// vertex may have the restart index.
void check_kept(Test& t, GLenum source, bool is_fixed_function) {
  gl.UseProgram(is_fixed_function ? 0 : colour_program(t));
  for (const DrawsInTurn& draws : {DrawsInTurn{draw_anew, draw_three, draw_anew}, {draw_often, draw_three}}) {
    prepare_triangle(source, is_fixed_function);
    expect_all_kept(t, draws);
    if (!t.is_gles()) gl.PrimitiveRestartIndex(7);
  }
}

// Enables one clip plane or clip distance at a time.
void check_clipping(Test& t, GLenum source, bool is_fixed_function) {
  GLint count = 0;
  gl.GetIntegerv(GL_MAX_CLIP_DISTANCES, &count);
  gl.UseProgram(is_fixed_function ? 0
                                  : build_program(t, {.vertex = "layout(location = 0) in vec4 position;\n"
                                                                "out vec4 colour; out float gl_ClipDistance[8];\n"
                                                                "void main() { colour = vec4(1.0, 0.5, 0.25, 1.0);\n"
                                                                "  for (int i = 0; i < 8; ++i)\n"
                                                                "    gl_ClipDistance[i] = position.x + position.y *\n"
                                                                "                         (0.2 * float(i) - 0.7);\n"
                                                                "  gl_Position = position; }\n"}));
  prepare_triangle(source, is_fixed_function);
  const auto expect_drawn = [&](const std::string& what) {
    gl.Disable(GL_ARK);
    Picture plain = picture_of(draw_three);
    gl.Enable(GL_ARK);
    for (const auto draw : {draw_anew, draw_three, draw_anew})
      t.expect_same_picture(picture_of(draw), plain, what, 3, 40);
    return plain;
  };
  for (int i = 0; i < std::min(count, 8); ++i) {
    const auto name = static_cast<GLenum>(GL_CLIP_DISTANCE0 + i);
    const GLdouble plane[4] = {1, 0.2 * i - 0.7, 0, 0};
    if (is_fixed_function) gl.ClipPlane(name, plane);
    gl.Enable(name);
    const Picture clipped = expect_drawn("clipped by " + as_text(i));
    gl.Disable(name);
    const Picture whole = expect_drawn("after clipping by " + as_text(i) + " was disabled");
    t.expect(count_different(clipped, whole, 8) > 500, "clipping shows");
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases kept_capabilities_cases() {
  Cases cases;
  for (const auto& [source, depths] : {std::pair<GLenum, const char*>{GL_UNIFORM_DEPTH_ARK, "uniform"},
                                       {GL_DEPTH_TAG_ARK, "tags"},
                                       {GL_MEASURED_DEPTH_ARK, "measured"}})
    for (const bool is_fixed_function : {false, true}) {
      const std::string end = (is_fixed_function ? ".fixed_function." : ".") + std::string(depths);
      cases.push_back(
          {.name = "ark.draw.keeps.capabilities" + end,
           .clauses = {"10.R.2-6", "11.R.10-2"},
           .plan = "Enable each capability, draw once or often, disable it, and draw: IsEnabled has the last value.",
           .wrong = "What a pass disabled is enabled again, though the application had disabled it.",
           .apis = is_fixed_function ? compat_only : every_api,
           .check = [source = source, is_fixed_function](Test& t) { check_kept(t, source, is_fixed_function); }});
      cases.push_back(
          {.name = "ark.draw.keeps.clipping" + end,
           .clauses = {"10.R.2-6", "chapter-14-14"},
           .plan = "Draw with each clip plane or distance, and again after it is disabled.",
           .wrong = "Clipping goes on after a refined draw.",
           .apis = is_fixed_function ? compat_only : desktop_apis,
           .check = [source = source, is_fixed_function](Test& t) { check_clipping(t, source, is_fixed_function); }});
    }
  return cases;
}

}  // namespace glark::conformance
