// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Depths of edges that a culled face hides, when the state of culling changes in each way that GL has: by a call, in a
// list that is called or only compiled, and with a group of attributes.
#include <string>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

void cull(GLenum face) { gl.CullFace(face); }

// From a triangle that shows its front to one that is hidden, if the change takes effect.
struct CullingChange {
  const char* leaf;
  void (*hide)();
  void (*prepare)() = [] {};
};
constexpr CullingChange culling_changes[] = {
    {"front_face", [] { gl.FrontFace(GL_CW); }},
    {"cull_face", [] { cull(GL_FRONT); }},
    {"both_faces", [] { cull(GL_FRONT_AND_BACK); }},
    {"enable", [] { gl.Enable(GL_CULL_FACE); },
     [] {
       gl.Disable(GL_CULL_FACE);
       cull(GL_FRONT);
     }},
};

struct CullingWay {
  const char* leaf;
  void (*take)(void (*hide)());
};

GLuint compiled_list(void (*hide)(), GLenum mode = GL_COMPILE) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, mode);
  hide();
  gl.EndList();
  return list;
}

constexpr CullingWay culling_ways[] = {
    {"call", [](void (*hide)()) { hide(); }},
    {"compiled_only", [](void (*hide)()) { compiled_list(hide); }},
    {"compiled_and_executed", [](void (*hide)()) { compiled_list(hide, GL_COMPILE_AND_EXECUTE); }},
    {"called_list", [](void (*hide)()) { gl.CallList(compiled_list(hide)); }},
    {"called_lists",
     [](void (*hide)()) {
       const GLuint list = compiled_list(hide);
       gl.ListBase(list - 1);
       constexpr GLubyte offset = 1;
       gl.CallLists(1, GL_UNSIGNED_BYTE, &offset);
     }},
    {"polygon_group",
     [](void (*hide)()) {
       gl.PushAttrib(GL_POLYGON_BIT);
       hide();
       gl.PopAttrib();
     }},
    {"enable_group",
     [](void (*hide)()) {
       gl.PushAttrib(GL_ENABLE_BIT);
       hide();
       gl.PopAttrib();
     }},
    {"refused",
     [](void (*hide)()) {
       hide();
       gl.CullFace(GL_LINES);
       gl.FrontFace(GL_FRONT);
       while (gl.GetError() != GL_NO_ERROR) continue;
     }},
};

GLuint curved_program(Test& t) {
  return build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;"
                                     "out vec4 colour; void main() { colour = vec4(1.0, 1.0, 1.0, 1.0 + normal.x);"
                                     "gl_Position = position; }"});
}

Mesh bulged_triangle() {
  Mesh mesh = one_triangle();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec4 place = mesh[i].position;
    mesh[i].normal = {place[0], place[1], 0.5F};
  }
  return mesh;
}

void draw_bulged() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

void check_way(Test& t, const CullingWay& way, bool is_welded) {
  gl.UseProgram(curved_program(t));
  upload(bulged_triangle());
  refine_uniformly(6, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 0);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 0.3F);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  const GLuint all = count_generated(draw_bulged);
  t.expect(all > 4, "the triangle is refined");
  const Picture nothing(surface_size, surface_size);
  for (const CullingChange& change : culling_changes) {
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_BACK);
    gl.FrontFace(GL_CCW);
    change.prepare();
    const Picture shown = picture_of(draw_bulged);
    const std::string what = std::string(change.leaf) + ", " + way.leaf;
    t.expect(count_different(shown, nothing, 8) > 200, "the triangle shows before " + what);
    way.take(change.hide);
    gl.Disable(GL_ARK);
    const bool is_shown = count_different(picture_of(draw_bulged), nothing, 8) > 0;
    gl.Enable(GL_ARK);
    const Picture after = picture_of(draw_bulged);
    t.expect_same_picture(after, is_shown ? shown : nothing, "the triangle after " + what, 2, 20);
    if (is_shown) t.expect_equal(count_generated(draw_bulged), all, "triangles of what shows after " + what);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases culling_states_cases() {
  Cases cases;
  for (const CullingWay& way : culling_ways)
    for (const bool is_welded : {false, true})
      cases.push_back(
          {.name = std::string("ark.depth.screen_error.culled_by.") + way.leaf + (is_welded ? ".welded" : ""),
           .clauses = {"11.R.4-19"},
           .plan = "The state of culling changes in one way. A triangle that shows has its depths, whatever a "
                   "list or a group says that is not in effect.",
           .wrong = "A state that is only compiled, refused or restored counts, and what shows stays coarse.",
           .apis = compat_only,
           .check = [&way, is_welded](Test& t) { check_way(t, way, is_welded); }});
  return cases;
}

}  // namespace glark::conformance
