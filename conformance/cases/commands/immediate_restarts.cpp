// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Restarts of primitives between Begin and End (GL_NV_primitive_restart): by PrimitiveRestartNV, and by an index of
// ArrayElement, in every mode of triangles.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "conformance/cases/cases.h"
#include "conformance/cases/commands/as_plain.h"

namespace glark::conformance {
namespace {

constexpr GLuint restart_list = 44;
constexpr GLuint restart_at = 200;

// Two corners for each n, from the left to the right.
struct RestartCorner {
  std::array<GLfloat, 2> place;
  std::array<GLfloat, 3> colour;
};
constexpr std::size_t restart_corners = 16;

const std::array<RestartCorner, restart_corners>& corners_to_restart() {
  static const std::array<RestartCorner, restart_corners> corners = [] {
    std::array<RestartCorner, restart_corners> all{};
    for (std::size_t i = 0; i < restart_corners; ++i) {
      const auto n = static_cast<float>(i);
      all[i] = {{-0.9F + 0.11F * n, i % 2 == 0 ? -0.7F + 0.02F * n : 0.8F - 0.03F * n},
                {0.9F - n / 20, 0.2F + n / 25, i % 3 == 0 ? 0.9F : 0.3F}};
    }
    return all;
  }();
  return corners;
}

// Gives one vertex, or restarts.
struct RestartWay {
  const char* leaf;
  void (*vertex)(std::size_t corner);
  void (*restart)();
};

void corner_by_values(std::size_t corner) {
  const RestartCorner& at = corners_to_restart()[corner];
  gl.Color3fv(at.colour.data());
  gl.Vertex2fv(at.place.data());
}
void corner_by_element(std::size_t corner) { gl.ArrayElement(static_cast<GLint>(corner)); }

constexpr RestartWay restart_ways[] = {
    {"vertices", corner_by_values, [] { gl.PrimitiveRestartNV(); }},
    {"elements", corner_by_element, [] { gl.PrimitiveRestartNV(); }},
    {"index", corner_by_element, [] { gl.ArrayElement(restart_at); }},
    {"index_among_vertices",
     [](std::size_t corner) { corner % 3 == 0 ? corner_by_element(corner) : corner_by_values(corner); },
     [] { gl.ArrayElement(restart_at); }},
};

struct RestartMode {
  const char* leaf;
  GLenum mode;
  int (*triangles)(int vertices);  // of a run
};
constexpr RestartMode restart_modes[] = {
    {"triangles", GL_TRIANGLES, [](int vertices) { return vertices / 3; }},
    {"triangle_strip", GL_TRIANGLE_STRIP, [](int vertices) { return std::max(vertices - 2, 0); }},
    {"triangle_fan", GL_TRIANGLE_FAN, [](int vertices) { return std::max(vertices - 2, 0); }},
    {"quads", GL_QUADS, [](int vertices) { return vertices / 4 * 2; }},
    {"quad_strip", GL_QUAD_STRIP, [](int vertices) { return std::max(vertices / 2 * 2 - 2, 0); }},
    {"polygon", GL_POLYGON, [](int vertices) { return std::max(vertices - 2, 0); }},
};

// The numbers of vertices between restarts: whole primitives and others, none, and restarts at both ends.
constexpr std::array<std::array<int, 4>, 4> restart_runs = {{{4, 4, 4, 4}, {3, 5, 4, 4}, {0, 7, 0, 6}, {5, 2, 6, 0}}};

void draw_restarted(GLenum mode, const RestartWay& way, const std::array<int, 4>& runs) {
  std::size_t corner = 0;
  gl.Begin(mode);
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (run > 0) way.restart();
    for (int i = 0; i < runs[run]; ++i) way.vertex(corner++);
  }
  gl.End();
}

GLuint triangles_of_runs(const RestartMode& mode, const std::array<int, 4>& runs) {
  int triangles = 0;
  for (const int vertices : runs) triangles += mode.triangles(vertices);
  return static_cast<GLuint>(triangles);
}

void use_restart(Test& t) {
  if (!t.has_extension("GL_NV_primitive_restart")) t.not_supported("there is no GL_NV_primitive_restart");
  const auto& corners = corners_to_restart();
  gl.VertexPointer(2, GL_FLOAT, sizeof(RestartCorner), corners[0].place.data());
  gl.ColorPointer(3, GL_FLOAT, sizeof(RestartCorner), corners[0].colour.data());
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY}) gl.EnableClientState(array);
  gl.PrimitiveRestartIndexNV(restart_at);
  gl.EnableClientState(GL_PRIMITIVE_RESTART_NV);
  refine_uniformly(2, GL_LINEAR_OUTPUTS_ARK);
}

// Mesa 22 joins the runs of a list, also those that are not whole primitives: they are as in its unrefined draw. There,
// a polygon of two vertices is a triangle.
void expect_restarted_list(Test& t, const RestartMode& mode, const std::function<void()>& draw,
                           const std::array<int, 4>& runs, const std::string& what) {
  if (mode.mode == GL_POLYGON && runs[1] == 2) return;
  gl.NewList(restart_list, GL_COMPILE);
  draw();
  gl.EndList();
  const auto call = [] { gl.CallList(restart_list); };
  const PlainDraw plain = plain_draw(call);
  AsPlain how{.is_often = true};
  if (mode.mode == GL_QUADS || mode.mode == GL_QUAD_STRIP) how.coarse = 2 * plain.triangles;
  if (mode.mode == GL_POLYGON) how.coarse = triangles_of_runs(mode, runs);
  expect_as_plain(t, plain, call, what, how);
}

void check_restarted(Test& t, const RestartMode& mode, const RestartWay& way) {
  use_restart(t);
  for (const std::array<int, 4>& runs : restart_runs) {
    const auto draw = [&] {
      gl.Color3f(0.5F, 0.6F, 0.7F);
      draw_restarted(mode.mode, way, runs);
    };
    const std::string what = fmt::format("runs of {}, {}, {}, {}", runs[0], runs[1], runs[2], runs[3]);
    const AsPlain how{.coarse = triangles_of_runs(mode, runs), .is_often = true};
    expect_as_plain(t, plain_draw(draw), draw, what, how);
    expect_restarted_list(t, mode, draw, runs, what + ", a list");
  }
  t.expect_no_error("the restarts");
}

// The index of restarts changes between draws: the same elements are other primitives.
void check_restart_index(Test& t) {
  use_restart(t);
  constexpr GLuint indices[] = {restart_at, 5, 8, 5, 3, restart_at};
  const auto draw = [] {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (GLint i = 0; i < 12; ++i) gl.ArrayElement(i);
    gl.End();
  };
  for (const bool is_list : {false, true})
    for (const GLuint index : indices) {
      gl.PrimitiveRestartIndexNV(index);
      if (is_list) {
        gl.NewList(restart_list, GL_COMPILE);
        draw();
        gl.EndList();
      }
      const std::function<void()> drawn =
          is_list ? std::function<void()>([] { gl.CallList(restart_list); }) : std::function<void()>(draw);
      const std::string what = fmt::format("{}, index {}", is_list ? "a list" : "direct", index);
      expect_as_plain(t, plain_draw(drawn), drawn, what, {.is_often = true});
    }
  t.expect_no_error("the indices of restarts");
}

}  // namespace

Cases immediate_restarts_cases() {
  Cases cases;
  for (const RestartMode& mode : restart_modes)
    for (const RestartWay& way : restart_ways)
      cases.push_back(optional(
          {.name = fmt::format("ark.command.restart.{}.{}", mode.leaf, way.leaf),
           .clauses = {"10.R.2-1", "11.R.3-1"},
           .plan = "Restart primitives between Begin and End, with runs of 0 to 7 vertices, directly and in lists: the "
                   "picture and the triangles are those of the unrefined draw.",
           .wrong = "A restart is not seen, so that triangles join two runs or are counted in excess.",
           .apis = compat_only,
           .check = [&mode, &way](Test& t) { check_restarted(t, mode, way); }}));
  cases.push_back(optional({.name = "ark.command.restart.changed_index",
                            .clauses = {"10.R.2-1", "11.R.3-1"},
                            .plan = "Draw the same elements with other indices of restarts, directly and in lists.",
                            .wrong = "A draw keeps the restarts of an earlier index.",
                            .apis = compat_only,
                            .check = check_restart_index}));
  return cases;
}

}  // namespace glark::conformance
