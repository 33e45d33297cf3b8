// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// State that changes between refined draws by a command, by a display list, or by PopAttrib. An implementation may keep a
// copy of the application's state for its own passes.
#include <array>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct ChangedState {
  const char* name;
  void (*first)();
  void (*second)();
  GLenum query;  // of up to four integers
};

constexpr ChangedState states[] = {
    {"Viewport", [] { gl.Viewport(8, 0, surface_size / 4, surface_size / 2); },
     [] { gl.Viewport(0, 0, surface_size, surface_size); }, GL_VIEWPORT},
    {"ShadeModel", [] { gl.ShadeModel(GL_FLAT); }, [] { gl.ShadeModel(GL_SMOOTH); }, GL_SHADE_MODEL},
    {"PolygonMode",
     [] {
       gl.PolygonMode(GL_FRONT, GL_LINE);
       gl.PolygonMode(GL_BACK, GL_POINT);
     },
     [] {
       gl.PolygonMode(GL_FRONT, GL_FILL);
       gl.PolygonMode(GL_BACK, GL_LINE);
     },
     GL_POLYGON_MODE},
    {"PolygonMode of the back", [] { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); },
     [] { gl.PolygonMode(GL_BACK, GL_LINE); }, GL_POLYGON_MODE},
    {"PolygonMode of the front", [] { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
     [] { gl.PolygonMode(GL_FRONT, GL_FILL); }, GL_POLYGON_MODE},
    {"CullFace", [] { gl.CullFace(GL_FRONT); }, [] { gl.CullFace(GL_BACK); }, GL_CULL_FACE_MODE},
    {"FrontFace", [] { gl.FrontFace(GL_CW); }, [] { gl.FrontFace(GL_CCW); }, GL_FRONT_FACE},
    {"MatrixMode", [] { gl.MatrixMode(GL_TEXTURE); }, [] { gl.MatrixMode(GL_MODELVIEW); }, GL_MATRIX_MODE},
    {"ListBase", [] { gl.ListBase(3); }, [] { gl.ListBase(0); }, GL_LIST_BASE},
    {"CLIP_PLANE1", [] { gl.Enable(GL_CLIP_PLANE1); }, [] { gl.Disable(GL_CLIP_PLANE1); }, GL_CLIP_PLANE1},
    {"CULL_FACE", [] { gl.Enable(GL_CULL_FACE); }, [] { gl.Disable(GL_CULL_FACE); }, GL_CULL_FACE},
    {"VERTEX_PROGRAM_TWO_SIDE", [] { gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE); },
     [] { gl.Disable(GL_VERTEX_PROGRAM_TWO_SIDE); }, GL_VERTEX_PROGRAM_TWO_SIDE},
    {"DepthMask", [] { gl.DepthMask(GL_FALSE); }, [] { gl.DepthMask(GL_TRUE); }, GL_DEPTH_WRITEMASK},
};

enum class ChangeWay { by_call, by_list, by_pop };

std::array<GLint, 4> values_of(GLenum query) {
  std::array<GLint, 4> values{};
  gl.GetIntegerv(query, values.data());
  return values;
}

void draw_one() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// A mesh that no draw has captured before.
void draw_new() {
  Mesh mesh = one_triangle({2, 2, 2});
  static float shift = 0;
  shift = shift > 0.01F ? 0 : shift + 0.0001F;  // less than a pixel
  for (MeshVertex& vertex : mesh) vertex.position[2] += shift;
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(MeshVertex)), mesh.data(),
                GL_STATIC_DRAW);
  draw_one();
}

void change_by(ChangeWay way, const ChangedState& state) {
  switch (way) {
    case ChangeWay::by_call: state.second(); break;
    case ChangeWay::by_list: gl.CallList(1); break;
    case ChangeWay::by_pop: gl.PopAttrib(); gl.Enable(GL_ARK);
  }
}

// Puts the state into its first value, so that change_by() gives it the second one.
void prepare(ChangeWay way, const ChangedState& state) {
  if (way == ChangeWay::by_pop) {
    state.first();
    state.second();
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  }
  state.first();
  if (way == ChangeWay::by_list) {
    gl.NewList(1, GL_COMPILE);
    state.second();
    gl.EndList();
  }
}

void check_state(Test& t, ChangeWay way, const ChangedState& state) {
  prepare(way, state);
  for (int again = 0; again < 2; ++again) draw_new();
  change_by(way, state);
  const std::array<GLint, 4> expected = values_of(state.query);
  const GLuint triangles = count_generated(draw_new);
  const std::string what = std::string("after ") + state.name;
  t.expect(values_of(state.query) == expected, what + ", a draw changes the state");
  const Picture refined = picture_of(draw_new);
  gl.Disable(GL_ARK);
  t.expect_same_picture(refined, picture_of(draw_one), what, 3, 40);
  gl.Enable(GL_ARK);
  state.second();
  t.expect_equal(count_generated(draw_new), triangles, "triangles " + what);
  t.expect(values_of(state.query) == expected, what + ", draws change the state");
  t.expect_no_error(what);
}

void check_states(Test& t, ChangeWay way, GLenum source) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle({2, 2, 2}));
  refine_by_tags(4, GL_LINEAR_OUTPUTS_ARK);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 10);
  for (const ChangedState& state : states) check_state(t, way, state);
}

}  // namespace

Cases changed_states_cases() {
  Cases cases;
  for (const auto& [way, name] : {std::pair<ChangeWay, const char*>{ChangeWay::by_call, "by_call"},
                                  {ChangeWay::by_list, "by_list"},
                                  {ChangeWay::by_pop, "by_pop"}})
    for (const auto& [source, depths] : {std::pair<GLenum, const char*>{GL_UNIFORM_DEPTH_ARK, "uniform"},
                                         {GL_DEPTH_TAG_ARK, "tags"},
                                         {GL_MEASURED_DEPTH_ARK, "measured"}})
      cases.push_back({.name = std::string("ark.state.changed.") + name + "." + depths,
                       .clauses = {"10.R.2-6", "11.R.10-1"},
                       .plan = "Change one state after another between refined draws. Compare pictures, counts and the "
                               "state itself.",
                       .wrong = "A refined draw sets the state back to an earlier value, or is drawn with it.",
                       .apis = compat_only,
                       .check = [way = way, source = source](Test& t) { check_states(t, way, source); }});
  return cases;
}

}  // namespace glark::conformance
