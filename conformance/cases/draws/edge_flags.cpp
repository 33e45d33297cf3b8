// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Edge flags have no effect on refined triangles (chapter 14), even if the draw repeats often.
#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

struct FlagWay {
  const char* leaf;
  GLenum source;
  bool is_fixed_function;
};

constexpr FlagWay flag_ways[] = {
    {"uniform", GL_UNIFORM_DEPTH_ARK, false},        {"tags", GL_DEPTH_TAG_ARK, false},
    {"measured", GL_MEASURED_DEPTH_ARK, false},      {"fixed_function.uniform", GL_UNIFORM_DEPTH_ARK, true},
    {"fixed_function.tags", GL_DEPTH_TAG_ARK, true}, {"fixed_function.measured", GL_MEASURED_DEPTH_ARK, true},
};

struct FlaggedDraw {
  const char* name;
  void (*draw)();
};

constexpr GLuint list_name = 1;

constexpr FlaggedDraw flagged_draws[] = {
    {"DrawArrays", [] { gl.DrawArrays(GL_TRIANGLES, 0, 3); }},
    {"DrawElements", [] { gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr); }},
    {"CallList", [] { gl.CallList(list_name); }},
};

bool shows_something(const Picture& picture) {
  return count_different(picture, Picture(surface_size, surface_size), 8) > 0;
}

// Edge flags are FALSE. `expected` is the picture with edge flags of TRUE.
void expect_ignored(Test& t, const FlaggedDraw& drawn, const Picture& expected, const std::string& what) {
  gl.Disable(GL_ARK);
  t.expect(!shows_something(picture_of(drawn.draw)), what + ": unrefined, no edge is a boundary edge");
  gl.Enable(GL_ARK);
  t.expect_same_picture(picture_of(drawn.draw), expected, what + ", first");
  repeat_often(drawn.draw);
  t.expect_same_picture(picture_of(drawn.draw), expected, what + ", repeated");
  gl.Disable(GL_ARK);
  t.expect(!shows_something(picture_of(drawn.draw)), what + ": edge flags are FALSE again in an unrefined draw");
  gl.Enable(GL_ARK);
}

void expect_flags_ignored(Test& t, const FlaggedDraw& drawn, const std::string& what) {
  gl.EdgeFlag(GL_TRUE);
  const Picture expected = picture_of(drawn.draw);
  t.expect(shows_something(expected), what + ": with edge flags of TRUE, something is drawn");
  gl.EdgeFlag(GL_FALSE);
  expect_ignored(t, drawn, expected, what + ", the current edge flag");
  gl.EdgeFlag(GL_TRUE);
  gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
  if (drawn.draw != flagged_draws[2].draw) expect_ignored(t, drawn, expected, what + ", an array of edge flags");
  gl.DisableClientState(GL_EDGE_FLAG_ARRAY);
}

// Makes arrays for both kinds of vertex stages, indices, and an array of edge flags that are FALSE.
void upload_with_flags() {
  upload(one_triangle({1, 3, 2}));
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), nullptr);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  const std::array<GLushort, 8> indices_and_flags = {0, 1, 2};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  for (const GLenum target : {GL_ELEMENT_ARRAY_BUFFER, GL_ARRAY_BUFFER}) gl.BindBuffer(target, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(indices_and_flags), indices_and_flags.data(), GL_STATIC_DRAW);
  gl.EdgeFlagPointer(0, reinterpret_cast<const void*>(std::size_t{6}));
}

void check_edge_flags(Test& t, const FlagWay& way) {
  gl.UseProgram(way.is_fixed_function ? 0 : colour_program(t));
  upload_with_flags();
  refine_uniformly(2);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(way.source));
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 20);
  gl.NewList(list_name, GL_COMPILE);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.EndList();
  for (const auto& [mode, name] : {std::pair<GLenum, std::string>{GL_LINE, "lines"}, {GL_POINT, "points"}})
    for (const FlaggedDraw& drawn : flagged_draws) {
      gl.PolygonMode(GL_FRONT_AND_BACK, mode);
      expect_flags_ignored(t, drawn, name + ", " + drawn.name);
    }
  t.expect_no_error("the draws");
}

}  // namespace

Cases edge_flags_cases() {
  Cases cases;
  for (const FlagWay& way : flag_ways)
    cases.push_back({.name = std::string("ark.draw.often.edge_flags.") + way.leaf,
                     .clauses = {"chapter-14-12", "chapter-14-11", "11.R.13-1"},
                     .plan =
                         "Draw in the modes LINE and POINT, once and often, with edge flags of FALSE: the picture is "
                         "that with edge flags of TRUE.",
                     .wrong = "A draw that repeats obeys the edge flags; the edge flag stays TRUE after it.",
                     .apis = compat_only,
                     .check = [way](Test& t) { check_edge_flags(t, way); }});
  return cases;
}

}  // namespace glark::conformance
